# SPDX-License-Identifier: MIT
# Digests of timed sources: one for each kernel of each API, of its file and all that it includes, and one for each host
# path. They need only the source tree. Comments (//), white space and include lines do not count, so that a file may
# move. build_info.cmake puts the digests into the program, which writes them into every record; paper/sources.py
# compares those with the tree's:
#   cmake -DSOURCE=. -DOUTPUT=digests.json -P bench/io/source_digests.cmake
cmake_minimum_required(VERSION 3.22)

# A host path is the code that makes the spheres, enqueues, waits and reads back; host/contacts is the part that only
# contacts and swept searches run. `measure` is the code that takes samples. crossover.h is left out: its figures decide
# the automatic choice, not what is then timed.
set(gpu_rooms common/scene common/scene/contact common/plan common/backend common/device common/simulation
  common/simulation/motion common/simulation/search)
set(rooms_of_host/cpu common/shared common/scene common/scene/contact common/plan common/backend common/cpu
  common/cpu/search)
set(rooms_of_host/glsl ${gpu_rooms} common/glsl glsl)
set(rooms_of_host/vulkan ${gpu_rooms} common/glsl vulkan/spirv vulkan/device vulkan)
set(rooms_of_host/cuda ${gpu_rooms} cuda/host interop)  # interop: OpenGL drawing CUDA's spheres
set(rooms_of_host/contacts ${gpu_rooms} common/shared common/shared/contact common/cpu common/cpu/search)
set(rooms_of_measure bench/measure)
set(files_of_contacts "/(cpu_)?(contact|near_pairs|swept)[^/]*$|/shared/contact/")

# Keeps the digest and the includes of a file for later.
function(read_source file)
  get_property(known GLOBAL PROPERTY "digest of ${file}" SET)
  if(known)
    return()
  endif()
  if(NOT EXISTS ${SOURCE}/${file})
    message(FATAL_ERROR "${SOURCE} has no ${file}, which a kernel includes: name the root of the sources in -DSOURCE")
  endif()
  file(READ ${SOURCE}/${file} text)
  string(REGEX MATCHALL "#include \"[^\"\n]*\"" includes "${text}")
  list(TRANSFORM includes REPLACE "#include \"(.*)\"" "\\1")
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX REPLACE "#include [^\n]*\n" "" text "${text}")
  string(REGEX REPLACE "[ \t\r\n]+" " " text "${text}")
  string(SHA256 digest "${text}")
  set_property(GLOBAL PROPERTY "digest of ${file}" ${digest})
  set_property(GLOBAL PROPERTY "includes of ${file}" ${includes})
endfunction()

# Appends a file and what it includes, each once, to the list.
function(add_with_includes file list)
  set(files ${${list}} ${file})
  read_source(${file})
  get_property(includes GLOBAL PROPERTY "includes of ${file}")
  foreach(include IN LISTS includes)
    if(NOT include IN_LIST files)
      add_with_includes(${include} files)
    endif()
  endforeach()
  set(${list} ${files} PARENT_SCOPE)
endfunction()

# Appends `"name": "digest"` to the list `entries`.
function(add_digest name)
  set(texts "")
  foreach(file IN LISTS ARGN)
    read_source(${file})
    get_property(digest GLOBAL PROPERTY "digest of ${file}")
    string(APPEND texts "${digest}\n")
  endforeach()
  string(SHA256 digest "${texts}")
  string(SUBSTRING ${digest} 0 12 digest)
  set(entries ${entries} "\"${name}\": \"${digest}\"" PARENT_SCOPE)
endfunction()

# A JSON object: glsl/collide_grid, cuda/collide_grid, host/glsl ...
function(digest_sources result)
  set(entries "")
  file(GLOB kernels RELATIVE ${SOURCE} ${SOURCE}/shaders/*/*.comp ${SOURCE}/shaders/*/*.vert ${SOURCE}/shaders/*/*.frag
    ${SOURCE}/cuda/*/*.cu)
  list(FILTER kernels EXCLUDE REGEX "^cuda/host/")
  if(NOT kernels)
    message(FATAL_ERROR "${SOURCE} has no kernels in shaders/ and cuda/: name the root of the sources in -DSOURCE")
  endif()
  foreach(kernel IN LISTS kernels)
    set(files "")
    add_with_includes(${kernel} files)
    string(REGEX REPLACE "^([a-z]+)/.*/([^/]+)$" "\\1/\\2" name ${kernel})
    string(REGEX REPLACE "^shaders/" "glsl/" name ${name})
    string(REGEX REPLACE "\\.(comp|cu)$" "" name ${name})
    add_digest(${name} ${files})
  endforeach()
  foreach(path host/cpu host/glsl host/cuda host/vulkan host/contacts measure)
    set(files "")
    foreach(room IN LISTS rooms_of_${path})
      file(GLOB found RELATIVE ${SOURCE} ${SOURCE}/${room}/*.h ${SOURCE}/${room}/*.c[pu]*)
      if(NOT found)
        message(FATAL_ERROR "${SOURCE} has no room ${room}: mend the host paths in bench/io/source_digests.cmake")
      endif()
      list(APPEND files ${found})
    endforeach()
    set(kept EXCLUDE)
    if(path STREQUAL host/contacts)
      set(kept INCLUDE)
    endif()
    list(FILTER files ${kept} REGEX "${files_of_contacts}")
    list(REMOVE_ITEM files common/backend/crossover.h)
    add_digest(${path} ${files})
  endforeach()
  list(JOIN entries ",\n " json)
  set(${result} "{${json}}\n" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  get_filename_component(SOURCE "${SOURCE}" ABSOLUTE)
  digest_sources(digests)
  file(WRITE ${OUTPUT} "${digests}")
endif()
