# What our own targets have in common: every warning, and small files compiled together. The door
# builds so (a newcomer waits for it); the presets for developers compile each file by itself.
option(MC_UNITY "compile the files of a target together" OFF)
option(MC_WERROR "a warning is an error" OFF)

# own_target(<target>): warnings as the project has them, assertions of the library on.
function(own_target target)
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/autograder ${CMAKE_SOURCE_DIR}/labs)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion)
  if(MC_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  if(MC_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()
