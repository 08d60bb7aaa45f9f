# SPDX-License-Identifier: MIT
# What `cmake --graphviz` draws: the libraries and programs of this project, without the tests.
set(GRAPHVIZ_GRAPH_NAME stickslip)
set(GRAPHVIZ_GENERATE_PER_TARGET FALSE)
set(GRAPHVIZ_GENERATE_DEPENDERS FALSE)
set(GRAPHVIZ_IGNORE_TARGETS stickslip_light stickslip_warnings "^stickslip_.*_tests$" stickslip_test_support "^stickslip_fuzz_.*"
                            "^[^s].*::.*" "^/.*")
