# What autograder/bench/figures.sh measures with. Not built unless asked for.
add_executable(bench_measurement EXCLUDE_FROM_ALL autograder/bench/measurement.cpp)
target_link_libraries(bench_measurement PRIVATE jail)

# Trusted code, timed in process, with the flags of submissions and without the newer instructions.
file(GLOB sources CONFIGURE_DEPENDS autograder/bench/variance.cpp solutions/variance.cpp)
foreach(program bench_variance bench_variance_baseline)
  add_executable(${program} EXCLUDE_FROM_ALL ${sources})
  target_include_directories(${program} PRIVATE labs ${LAB_INCLUDES})
  target_compile_options(${program} PRIVATE ${PROGRAM_FLAGS})
endforeach()
if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
  target_compile_options(bench_variance PRIVATE -march=x86-64-v3)
endif()

# Lab 5 beside GSL's Halton and Sobol' sequences, where GSL is installed (libgsl-dev, gsl-devel).
if(GSL AND GSL_BLAS)
  add_executable(bench_halton EXCLUDE_FROM_ALL autograder/bench/halton.cpp solutions/halton.cpp)
  target_include_directories(bench_halton PRIVATE labs ${LAB_INCLUDES})
  target_compile_options(bench_halton PRIVATE ${PROGRAM_FLAGS})
  target_link_libraries(bench_halton PRIVATE ${GSL} ${GSL_BLAS})
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    target_compile_options(bench_halton PRIVATE -march=x86-64-v3)
  endif()
endif()
