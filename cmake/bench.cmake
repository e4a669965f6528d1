# The cost of one measurement, for autograder/bench/limits.sh. Built only on request.
add_executable(bench_measurement EXCLUDE_FROM_ALL autograder/bench/measurement.cpp)
target_link_libraries(bench_measurement PRIVATE sandbox)
own_target(bench_measurement)

# The ratios of ./lab bench: trusted code, timed in process, with the flags of submissions and
# without the newer instructions.
add_custom_target(bench_programs)
find_path(OPENQMC_INCLUDE oqmc/pmj.h)  # header-only; a checkout of it needs cmake -D OPENQMC_INCLUDE=
if(solutions_FILES)
  file(GLOB sources CONFIGURE_DEPENDS autograder/bench/ratios/*.cpp)
  list(APPEND sources ${solutions_FILES})
  foreach(program bench_ratios bench_ratios_baseline)
    add_executable(${program} EXCLUDE_FROM_ALL ${sources})
    add_dependencies(bench_programs ${program})
    target_include_directories(${program} PRIVATE autograder labs ${LAB_INCLUDES})
    target_compile_options(${program} PRIVATE ${PROGRAM_FLAGS})
    target_compile_definitions(${program} PRIVATE ${PEER_DEFINITIONS} _GLIBCXX_ASSERTIONS)
    target_link_libraries(${program} PRIVATE ${PEER_LIBRARIES})
    if(OPENQMC_INCLUDE)
      target_compile_definitions(${program} PRIVATE MC_HAVE_OPENQMC)
      target_include_directories(${program} SYSTEM PRIVATE ${OPENQMC_INCLUDE})
    endif()
  endforeach()
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    target_compile_options(bench_ratios PRIVATE -march=x86-64-v3)
  endif()
endif()
