# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ file with commit, compiler, flags and the digests of the sources. It is touched only
# when its text changes.
find_program(GIT git)
set(COMMIT "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE head OUTPUT_STRIP_TRAILING_WHITESPACE
                  RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
    set(COMMIT "${head}")
    if(changes)
      string(APPEND COMMIT "-dirty")
    endif()
  endif()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/source_digests.cmake)
digest_sources(digests)
file(WRITE ${OUTPUT}.new "// SPDX-License-Identifier: MIT
#include \"bench/io/context.h\"

namespace spherepair {
const BuildInfo build_info = {
    R\"(${VERSION})\", R\"(${COMMIT})\", R\"(${COMPILER})\", R\"(${FLAGS})\", R\"(${CUDA_COMPILER})\",
    R\"(${digests})\"};
}  // namespace spherepair
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different ${OUTPUT}.new ${OUTPUT})
file(REMOVE ${OUTPUT}.new)
