# What our own targets have in common: every warning, and small files compiled together. The entry script
# builds so (a newcomer waits for it); the presets for developers compile each file by itself.
option(MC_UNITY "compile the files of a target together" OFF)
option(MC_WERROR "a warning is an error" OFF)
option(MC_SANITIZE "grader and checks under the address and undefined-behavior sanitizers" OFF)

# with_warnings(<target>): every warning that the project promises to be free of.
function(with_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion)
  if(MC_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# own_target(<target>): of grader and checks; assertions of the library on. Programs of submissions
# are none of them: a sanitizer's run-time library needs system calls that the jail does not allow.
function(own_target target)
  with_warnings(${target})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/autograder ${CMAKE_SOURCE_DIR}/labs)
  target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  if(MC_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  if(MC_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all)
    target_compile_options(${target} PRIVATE ${sanitizers} -fno-omit-frame-pointer -g)
    target_link_options(${target} PRIVATE ${sanitizers})
  endif()
endfunction()

# in_parts(<target> <files>): so many files compiled together, not all: one compiler takes 500 MB at
# most (autograder/bench/figures.sh).
function(in_parts target files)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${files})
endfunction()
