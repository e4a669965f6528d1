# In a handout each task is a test: ctest -R 1.3, and the test explorers of editors. A task is in the
# header of its lab, "/// 1.3  …".
enable_testing()
file(GLOB headers ${CMAKE_CURRENT_SOURCE_DIR}/labs/[0-9]*-*/*.hpp)
foreach(header ${headers})
  file(STRINGS ${header} tasks REGEX "^ */// [0-9]+[.][0-9]+  ")
  foreach(task ${tasks})
    string(REGEX REPLACE "^ */// ([0-9]+[.][0-9]+)  .*" "\\1" task "${task}")
    if(NOT TEST ${task})
      add_test(NAME ${task} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/lab check ${task})
    endif()
  endforeach()
endforeach()
