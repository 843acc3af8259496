# SPDX-License-Identifier: MIT
# Digests of what is timed: one for each kernel of each API, of its file and all that it includes, and one for each
# host path. They need the source tree alone; // comments, white space and the lines that include do not count, so that a
# file may move. build_info.cmake puts them into the program, which writes them into every record; paper/sources.py
# compares those with the tree's:
#   cmake -DSOURCE=. -DOUTPUT=digests.json -P bench/io/source_digests.cmake
cmake_minimum_required(VERSION 3.22)

# A host path is what makes the spheres and enqueues, waits and reads back; what only contacts and swept searches run
# is host/contacts. `measure` is how every sample is taken. By the figures of crossover.h the automatic choice is made, not
# what is then timed.
set(gpu_rooms common/scene common/scene/contact common/backend common/device common/simulation common/simulation/motion
  common/simulation/search)
set(rooms_of_host/cpu common/shared common/scene common/scene/contact common/backend common/cpu common/cpu/search)
set(rooms_of_host/glsl ${gpu_rooms} glsl)
set(rooms_of_host/cuda ${gpu_rooms} cuda/host interop)  # interop: OpenGL drawing CUDA's spheres
set(rooms_of_host/contacts ${gpu_rooms} common/shared common/shared/contact common/cpu common/cpu/search)
set(rooms_of_measure bench/measure)
set(files_of_contacts "/(cpu_)?(contact|near_pairs|swept)[^/]*$|/shared/contact/")

# The digest of a file's text as it is, and of the text as which it counts, where what has changed between them is nothing to
# what records time. They go when all is recorded anew. Here: slots and fields of one meaning each, in other places.
set(counts_as_08e54c2f24e5c34b7f16c5ae9a35f404625de7d84249962ea5dd1b17af437d17
  c6345b47583471d112ee490d712e42f20ba7095c9a6fd4a1f82f38bf7bfae1e3)  # layout.h
set(counts_as_d59c9b93e9ce52505572c1f612545d4bbd4b5c81a1af56ca2246fc6ec6937448
  e5164df3abb6c04d514ddf9c08fbc0442eda2bdbd091ceb769ef1e091b2f801f)  # contact_rest.h
set(counts_as_a2370f463652ca9830507a3021c846cc5f761a2cac79e5fec28a06d3b46012a6
  dd6ddf8ee3712eba213798f9ee712a6f5079099ecfb5a164d8d16121e205e9d8)  # collide_grid.cu
set(counts_as_4d85e6eeff7169b546028c1143b342246c70bcdc3a555a8bac0e57d02d034616
  c4379dce9fdc1b4b7bcecdcc2a8992a7083853f049bf9dd8805d3b41ce6f5b89)  # contact_pairs.cu
set(counts_as_e2a4f057ae3759adf4d1064730518c3d66f8de609f65e91490c86f40e8debbe9
  e2f59f837393690a5cdfc08f704f21fa8dcbaeb183d5a868ea82a0b369bcac05)  # contact_rest.cuh
set(counts_as_b172fd810d7777c8a1af8caca2cd465d2e1e58ad14d5bbc5deb81fe4445103e0
  1e157badf4c0043cf3d84b2d664a569b8666bec30d85dbb988692ecdbcff824a)  # leapfrog.cu
set(counts_as_a69c068747d7c9c6c0851de6571ffd65c120e050b36cbace404649acbd0f5140
  68116775890127c70632128808cf55aaba07cf2e08406dbf9b3ca38b1046efeb)  # kernels.h
set(counts_as_ebbbffcc714bb5b00c199718fdedc74a6d90c415f22ceef0586691d78e4c100f
  055696e0c3c1e680274d336c1e257161b293687c2f6b5524f52b01bda94fdd76)  # collide_tensor.cu
set(counts_as_6da1e1b80ddb196e595e5ab0f409060ec3c205595ce9accc72f34fbe0b818ff6
  0b8f98cc1ed1503e3d92c0860eea4e656282fe662f4312362e8313642c6689a2)  # collide_grid.comp
set(counts_as_38280be8d79f4edd275259abf94992e8628042ad141acbe2b2d62a4f3e753513
  18e0126c88ce15dace01e4bf7cf0468ad2a4cbcdfa899c1d5f50d5cf3c6ce7d8)  # contact_pairs.comp
set(counts_as_0badfec3b6c0788f8a7dd693f3ce075d8270a1ee4234be472040d4fd09da29cb
  4327356d837e51d9bf56e746276a60cab9af0ffa8e5d91659575ffe6539119d2)  # contact_rest.glsl
set(counts_as_2d4893fcc215398eafda88346fbc791e86e02391ac795289e758a7b1564492c1
  656573eb5d9bccf52bb2603416817830a0252c4ac4121bea69abe166b9fc06b6)  # leapfrog.comp

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
  if(DEFINED counts_as_${digest})
    set(digest ${counts_as_${digest}})
  endif()
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
  foreach(path host/cpu host/glsl host/cuda host/contacts measure)
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
