# The repository's own tests: `ctest`, or `./lab test`.
enable_testing()

file(GLOB sources CONFIGURE_DEPENDS autograder/tests/*_test.cpp)
add_executable(grader_tests EXCLUDE_FROM_ALL ${sources})
own_target(grader_tests)
in_parts(grader_tests 12)
# Boost's headers take as much memory as the rest of a part.
set_source_files_properties(autograder/tests/boost_test.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_link_libraries(grader_tests PRIVATE grading coursework measuring)
target_include_directories(grader_tests PRIVATE ${LAB_INCLUDES})
target_compile_definitions(grader_tests PRIVATE MC_LAB="${CMAKE_SOURCE_DIR}/lab")
# The solutions with the programs' flags: their fast versions are compared with their definitions.
add_library(solutions OBJECT EXCLUDE_FROM_ALL ${solutions_FILES})
target_include_directories(solutions PRIVATE labs ${LAB_INCLUDES})
target_compile_options(solutions PRIVATE ${PROGRAM_FLAGS})
with_warnings(solutions)
target_sources(grader_tests PRIVATE $<TARGET_OBJECTS:solutions>)

file(GLOB sources CONFIGURE_DEPENDS autograder/tests/self_test/*.cpp)
add_executable(self_test EXCLUDE_FROM_ALL ${sources} autograder/checks/support/distributions.cpp)
own_target(self_test)
target_link_libraries(self_test PRIVATE grading)

# Mutation testing, by ./lab test --mutants LAB.
add_executable(mutants EXCLUDE_FROM_ALL autograder/tests/mutants/main.cpp autograder/tests/mutants/mutate.cpp)
own_target(mutants)
target_link_libraries(mutants PRIVATE grading)

# Intake, batches, failing machines: the tests of what only graders use.
file(GLOB sources CONFIGURE_DEPENDS autograder/tests/gradebook/*.cpp)
add_executable(gradebook_tests EXCLUDE_FROM_ALL ${sources})
own_target(gradebook_tests)
in_parts(gradebook_tests 8)
target_link_libraries(gradebook_tests PRIVATE grading coursework Catch2::Catch2WithMain)
if(CMAKE_SYSTEM_NAME STREQUAL Linux)
  add_executable(faulty_machine EXCLUDE_FROM_ALL autograder/tests/faulty_machine/main.cpp)
  own_target(faulty_machine)
  if(SECCOMP_LIBRARY AND SECCOMP_INCLUDE)
    target_compile_definitions(faulty_machine PRIVATE MC_HAVE_SECCOMP)
    target_include_directories(faulty_machine PRIVATE ${SECCOMP_INCLUDE})
    target_link_libraries(faulty_machine PRIVATE ${SECCOMP_LIBRARY})
  endif()
  add_dependencies(gradebook_tests faulty_machine)
endif()
add_dependencies(gradebook_tests course checks_variance checks_independent
  experiments_variance experiments_independent runner)

# test_of(<name> <cost> <command>...): long tests start first. The time limit depends on the number of
# seeds: see cmake/test.cmake.
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
test_of(gradebook 100 gradebook_tests)
test_of(repository 5 self_test repository)
# Not in --quick: tests that build a checkout or measure, and those as long as all others together.
test_of(checkout 99 gradebook_tests "[checkout]")
test_of(handout 98 gradebook_tests "[handout]")
test_of(gradescope 98 gradebook_tests "[gradescope]")
test_of(slurm 97 sh autograder/tests/slurm.sh ${CMAKE_BINARY_DIR})  # skipped without Slurm
test_of(term 96 gradebook_tests "[term]")
test_of(interrupted 95 gradebook_tests "[interrupted]")
test_of(machine 94 gradebook_tests "[machine]")
test_of(class 93 gradebook_tests "[class]")
test_of(descriptors 93 grader_tests "[descriptors]")
test_of(update 92 gradebook_tests "[update]")
test_of(numbers 92 grader_tests "[numbers]")
test_of(demo 91 grader_tests "[demo]")
test_of(sanitizers 90 grader_tests "[sanitizers]")
set(quick grader script gradebook repository)
foreach(name ${quick})
  quick(${name})
endforeach()

# Every submission of the repository, with its expected result; --quick tests the first of each kind,
# and a mistake of each lab. A file named for a task is a catalog: each of its mistakes or attacks is a
# test. The first test of a catalog compiles it, so it starts before the others, which would wait for it.
foreach(lab ${LABS})
  foreach(who starter solutions)
    if(EXISTS ${CMAKE_SOURCE_DIR}/${who}/${lab}.cpp)
      test_of(${who}/${lab} 50 self_test ${who}/${lab}.cpp)
    endif()
  endforeach()
endforeach()
file(GLOB_RECURSE submissions CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/autograder/submissions
  autograder/submissions/*.cpp)
list(SORT submissions)
set(tested)  # by --quick
foreach(file ${submissions})
  string(REGEX REPLACE "[.]cpp$" "" name ${file})
  get_filename_component(folder ${file} DIRECTORY)
  set(cost 10)
  if(name MATCHES "^alternatives/")
    set(cost 40)
  endif()
  if(name MATCHES "/[0-9][^/]*$")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS autograder/submissions/${file})
    set(begins "^namespace mc::")
    if(name MATCHES "^attacks/")
      set(begins "^//// ")
    endif()
    file(STRINGS autograder/submissions/${file} names REGEX "${begins}[a-z0-9_]+( {)?$")
    list(TRANSFORM names REPLACE "${begins}([a-z0-9_]+).*$" "\\1")
    set(cost 11)
    foreach(mistake ${names})
      test_of(${folder}/${mistake} ${cost} self_test autograder/submissions/${file} ${mistake})
      set(cost 10)
    endforeach()
    list(GET names 0 mistake)
    set(name ${folder}/${mistake})
  else()
    test_of(${name} ${cost} self_test autograder/submissions/${file})
  endif()
  string(REGEX MATCH "^mistakes/[^/]+|^[^/]+" group ${name})
  if(NOT group IN_LIST tested)
    list(APPEND tested ${group})
    quick(${name})
  endif()
endforeach()

# Programs that lie: the solutions' answers, some of them replaced on the way (tests/fuzz). The
# fuzzing wire comes before the labs' own in the include path.
function(with_fuzzing_wire target)
  target_include_directories(${target} BEFORE PRIVATE autograder/tests/fuzz)
  target_include_directories(${target} PRIVATE labs ${LAB_INCLUDES})
  target_compile_options(${target} PRIVATE ${PROGRAM_FLAGS} -O1)
endfunction()
add_library(fuzz_runner OBJECT EXCLUDE_FROM_ALL labs/runner/main.cpp labs/runner/list.cpp
  labs/runner/table.cpp labs/runner/text.cpp autograder/tests/fuzz/mutation.cpp)
with_fuzzing_wire(fuzz_runner)
add_custom_target(fuzz_programs)
foreach(lab ${LABS})
  if(EXISTS ${CMAKE_SOURCE_DIR}/solutions/${lab}.cpp)
    file(GLOB experiments CONFIGURE_DEPENDS labs/[0-9]*-*/experiments.cpp)
    string(REPLACE "_" "-" dashed ${lab})
    list(FILTER experiments INCLUDE REGEX "/[0-9]+-${dashed}/")
    add_executable(fuzz_${lab} EXCLUDE_FROM_ALL ${experiments} $<TARGET_OBJECTS:fuzz_runner>
      $<TARGET_OBJECTS:solutions>)
    with_fuzzing_wire(fuzz_${lab})
    target_link_options(fuzz_${lab} PRIVATE ${PROGRAM_LINK_FLAGS})
    add_dependencies(fuzz_programs fuzz_${lab})
    test_of(fuzz/${lab} 20 self_test fuzz ${lab} 6)
  endif()
endforeach()

# With `all`, every file of ours (.ci/warnings).
add_custom_target(tests)
add_dependencies(tests grader_tests gradebook_tests self_test bench_measurement)
