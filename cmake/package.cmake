# SPDX-License-Identifier: MIT
# `cpack` in the build folder makes a Debian package of what is installed. It depends on the packages that have the
# libraries it is linked to; drivers of GPUs are found when a backend opens.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME spherepair)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Exact neighbour lists and sphere overlaps: library and program")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the spherepair authors")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)  # dpkg then refreshes the loader's cache
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
include(CPack)
