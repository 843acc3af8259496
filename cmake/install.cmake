# SPDX-License-Identifier: MIT
# What `cmake --install` copies: the library, its headers, the program, and what CMake and pkg-config need to find them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/spherepair)

install(TARGETS spherepair_shared EXPORT spherepair)
if(TARGET spherepair)
  install(TARGETS spherepair)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ TYPE INCLUDE FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")

# The targets are the whole configuration: what links to the library needs no other package.
install(EXPORT spherepair NAMESPACE spherepair:: FILE spherepairConfig.cmake DESTINATION ${config_folder})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(compatible SameMinorVersion)
else()
  set(compatible SameMajorVersion)
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/spherepairConfigVersion.cmake COMPATIBILITY ${compatible})
install(FILES ${PROJECT_BINARY_DIR}/spherepairConfigVersion.cmake DESTINATION ${config_folder})

# Paths in the file start where it lies, so that the prefix can be chosen at installation.
file(RELATIVE_PATH prefix_from_here ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_here ${prefix_from_here})
configure_file(${PROJECT_SOURCE_DIR}/cmake/spherepair.pc.in ${PROJECT_BINARY_DIR}/spherepair.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/spherepair.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
