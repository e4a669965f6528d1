# Settings of all our targets: every warning, and small files compiled together, because users wait for
# the build; developers' presets compile each file separately.
option(MC_UNITY "compile the files of a target together" ON)
option(MC_WERROR "a warning is an error" OFF)
option(MC_SANITIZE "grader and checks under the address and undefined-behavior sanitizers" OFF)
option(MC_COVERAGE "count the lines of sandbox, protocol and grader that run (.ci/coverage)" OFF)

# with_warnings(<target>): the warnings that the project is free of.
function(with_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
    -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)  # no program names the directory that it was built in
  if(MC_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# own_target(<target>): for grader and checks; enables the library's assertions. Not for programs of
# submissions: a sanitizer's run-time library needs system calls that the jail does not allow.
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
  if(MC_COVERAGE AND target MATCHES "^(sandbox|protocol|judge|archives)$")
    target_compile_options(${target} PRIVATE -g -O0 --coverage)
    target_link_libraries(${target} PUBLIC --coverage)
  endif()
endfunction()

# in_parts(<target> <files>): compiles that many files together, so that one compiler takes at most
# 500 MB.
function(in_parts target files)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${files})
endfunction()
