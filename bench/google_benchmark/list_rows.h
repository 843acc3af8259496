// SPDX-License-Identifier: MIT
// Google Benchmark's rows of lists: crystals, batches and packed points, from points to columns in a device's memory.
#pragma once

#include "bench/measure/session.h"

namespace spherepair {

// Registers BACKEND/list/SCENE for each open backend. A list that differs from the one of the backend before it is an
// error of the row, and sets `wrong`. The rows use the session as long as it lives.
void register_list_rows(Session& session, bool& wrong);

}  // namespace spherepair
