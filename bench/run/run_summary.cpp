// SPDX-License-Identifier: MIT
// The summary at the end of a run.
#include <fmt/format.h>

#include "bench/run/run_steps.h"
#include "common/scene/counted.h"

namespace spherepair {

std::string text_of(const RunSummary& summary) {
  std::string text = fmt::format("simulated {:.6g} s, to step {}; greatest speed {:.3g} m/s", summary.seconds,
                                 summary.step, summary.greatest_speed);
  if (summary.at_rest) text += *summary.at_rest ? ", at rest to the bit" : ", not at rest";
  text += "\n";
  if (!summary.contacts) return text;
  const ContactStatistics& now = *summary.contacts;
  return text + fmt::format("{}, {} with the walls; greatest overlap {:.3g} m; kinetic energy {:.4g} J of {:.4g} J\n",
                            counted(now.contacts, "contact"), now.wall_contacts, now.greatest_overlap, now.kinetic,
                            now.energy());
}

json to_json(const RunSummary& summary) {
  json out = {{"step", summary.step}, {"seconds", summary.seconds}, {"greatest_speed", summary.greatest_speed}};
  if (summary.at_rest) out["at_rest"] = *summary.at_rest;
  if (!summary.contacts) return out;
  out["contacts"] = summary.contacts->contacts;
  out["wall_contacts"] = summary.contacts->wall_contacts;
  out["greatest_overlap"] = summary.contacts->greatest_overlap;
  out["kinetic"] = summary.contacts->kinetic;
  out["energy"] = summary.contacts->energy();
  return out;
}

}  // namespace spherepair
