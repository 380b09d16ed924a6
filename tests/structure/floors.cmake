# No include runs up a floor. The floors, the lowest first, as patterns of the files that stand on them; a file that fits
# several stands on the highest.
cmake_minimum_required(VERSION 3.22)

set(floors
    "^src/simd/|^include/graze/(detail/)?[a-z0-9_]+\\.hpp$"
    "^src/shape/|^include/graze/(shape[./]|swept\\.hpp$)"
    "^src/(narrow|cast|rays|broad|plane)/|^include/graze/(plane/|(broad_phase|dynamic_tree|pairs|pair_changes|batch_pairs)\\.hpp$)"
    "^src/composite/"
    "^src/query/|^include/graze/(query|feature_corners|cast|raycast|typed_query|batch|batch_raycast|contact_motion)\\.hpp$"
    "^src/world/|^include/graze/(world[./]|slide\\.hpp$|plane/(reduce|slide|space|world)\\.hpp$)"
    "^src/dynamics/|^include/graze/((plane/)?(free_motion|blows|dynamics|joint|rigid|simulation)|impulse|mass|material|plane/contact_motion)\\.hpp$"
    "^src/(draw|capture)/|^include/graze/(draw|tessellate|capture|state_bytes|plane/capture)\\.hpp$"
    "^src/(tbb|io|mpi)/|^include/graze/(io/|mpi/|tbb_executor\\.hpp$)"
    "^include/graze/graze\\.hpp$")

function(floor_of file result)
  set(highest -1)
  set(number 0)
  foreach(pattern IN LISTS floors)
    if(file MATCHES "${pattern}")
      set(highest ${number})
    endif()
    math(EXPR number "${number} + 1")
  endforeach()
  if(highest EQUAL -1)
    message(FATAL_ERROR "${file} stands on no floor: name its folder in ${CMAKE_CURRENT_LIST_FILE}")
  endif()
  set(${result} ${highest} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/src/*.hpp" "${ROOT}/src/*.cpp" "${ROOT}/include/*.hpp")
if(NOT files)
  message(FATAL_ERROR "no sources in ${ROOT}")
endif()
set(upwards "")
foreach(file IN LISTS files)
  floor_of("${file}" here)
  file(STRINGS "${ROOT}/${file}" includes REGEX "^#include \"")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" included "${line}")
    if(EXISTS "${ROOT}/include/${included}")
      set(included "include/${included}")
    else()
      set(included "src/${included}")
    endif()
    floor_of("${included}" there)
    if(there GREATER here)
      string(APPEND upwards "\n  ${file} includes ${included}")
    endif()
  endforeach()
endforeach()
if(upwards)
  message(FATAL_ERROR "Includes that run up a floor:${upwards}")
endif()
