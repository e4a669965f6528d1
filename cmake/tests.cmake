# The repository's own tests: `ctest`, or `./lab test`.
enable_testing()

file(GLOB sources CONFIGURE_DEPENDS autograder/tests/*_test.cpp autograder/tests/classes/*_test.cpp)
add_executable(grader_tests ${sources})
own_target(grader_tests)
in_parts(grader_tests 12)
target_link_libraries(grader_tests PRIVATE judge measuring)
target_include_directories(grader_tests PRIVATE ${LAB_INCLUDES})
target_compile_definitions(grader_tests PRIVATE MC_LAB="${CMAKE_SOURCE_DIR}/lab")
# The solutions with the programs' flags: their fast versions are compared with their definitions.
add_library(solutions OBJECT ${solutions_FILES})
target_include_directories(solutions PRIVATE labs ${LAB_INCLUDES})
target_compile_options(solutions PRIVATE ${PROGRAM_FLAGS})
with_warnings(solutions)
target_sources(grader_tests PRIVATE $<TARGET_OBJECTS:solutions>)

file(GLOB sources CONFIGURE_DEPENDS autograder/tests/self_test/*.cpp)
add_executable(self_test ${sources} autograder/checks/support/distributions.cpp)
own_target(self_test)
target_link_libraries(self_test PRIVATE judge)

add_executable(faulty_machine autograder/tests/faulty_machine/main.cpp)
own_target(faulty_machine)
if(SECCOMP_LIBRARY AND SECCOMP_INCLUDE)
  target_compile_definitions(faulty_machine PRIVATE MC_HAVE_SECCOMP)
  target_include_directories(faulty_machine PRIVATE ${SECCOMP_INCLUDE})
  target_link_libraries(faulty_machine PRIVATE ${SECCOMP_LIBRARY})
endif()

# test_of(<name> <cost> <command>...): long tests start first.
function(test_of name cost)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES COST ${cost} SKIP_RETURN_CODE 77)
endfunction()
# ./lab test --quick runs these.
function(quick name)
  set_tests_properties(${name} PROPERTIES LABELS quick)
endfunction()

# The tests of ./lab's commands are separate, so that both halves run in parallel.
test_of(grader 100 grader_tests "~[script]~[.]")
test_of(script 100 grader_tests "[script]~[.]")
test_of(repository 5 self_test repository)
# Not in --quick: tests that build a checkout or measure, and those as long as all others together.
foreach(tag checkout handout gradescope interrupted machine class demo sanitizers slow)
  test_of(${tag} 95 grader_tests "[${tag}]")
endforeach()
test_of(numbers 95 ${CMAKE_COMMAND} -E env MC_BUILD=${CMAKE_BINARY_DIR} MC_NO_BUILD=1
  sh docs/refresh.sh --check)
test_of(slurm 97 sh autograder/tests/slurm.sh ${CMAKE_BINARY_DIR})  # skipped without Slurm
set(quick grader script repository)
foreach(name ${quick})
  quick(${name})
endforeach()

# Every submission of the repository is a test: self_test lists them with what they are.
file(GLOB_RECURSE submissions CONFIGURE_DEPENDS autograder/submissions/*.cpp starter/*.cpp solutions/*.cpp)
set(listed ${CMAKE_BINARY_DIR}/submissions.cmake)
add_custom_command(OUTPUT ${listed} COMMAND self_test list > ${listed} DEPENDS self_test ${submissions}
  COMMENT "Listing submissions")
add_custom_target(listed_submissions ALL DEPENDS ${listed})
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${listed})

# Programs that lie: the solutions' answers, some of them replaced on the way (tests/fuzz). The
# fuzzing wire comes before the labs' own in the include path.
function(with_fuzzing_wire target)
  target_include_directories(${target} BEFORE PRIVATE autograder/tests/fuzz)
  target_include_directories(${target} PRIVATE labs ${LAB_INCLUDES})
  target_compile_options(${target} PRIVATE ${PROGRAM_FLAGS} -O1)
endfunction()
add_library(fuzz_runner OBJECT labs/runner/main.cpp labs/runner/list.cpp
  labs/runner/table.cpp labs/runner/text.cpp)
with_fuzzing_wire(fuzz_runner)
foreach(lab ${LABS})
  if(EXISTS ${CMAKE_SOURCE_DIR}/solutions/${lab}.cpp)
    file(GLOB experiments CONFIGURE_DEPENDS labs/[0-9]*-*/experiments.cpp)
    string(REPLACE "_" "-" dashed ${lab})
    list(FILTER experiments INCLUDE REGEX "/[0-9]+-${dashed}/")
    add_executable(fuzz_${lab} ${experiments} $<TARGET_OBJECTS:fuzz_runner>
      $<TARGET_OBJECTS:solutions>)
    with_fuzzing_wire(fuzz_${lab})
    target_link_options(fuzz_${lab} PRIVATE ${PROGRAM_LINK_FLAGS})
    test_of(fuzz/${lab} 20 self_test fuzz ${lab} 6)
  endif()
endforeach()
