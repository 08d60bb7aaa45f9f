# SPDX-License-Identifier: MIT
# What makes the build faster and changes no result.

# GCC collects garbage often by default. For the templates of Eigen this takes a tenth of the compile time.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("SHELL:--param ggc-min-heapsize=1048576") # kB
endif()

# A compiler cache where there is one. It keeps what uses precompiled headers only if they are named in the preprocessed source.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()

# Linked PRIVATE by the targets whose computing time is spent in solver/ and analytic/: the studies, the command line, the
# report, the tests. With less optimisation they compile faster and run equally fast.
add_library(stickslip_o1 INTERFACE)
target_compile_options(stickslip_o1 INTERFACE $<$<CONFIG:Release>:-O1>)
