# SPDX-License-Identifier: MIT
# Runs every subcommand on a small problem under valgrind. Variables: VALGRIND, PROGRAM, FOLDER (is emptied).
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

foreach(
  command IN
  ITEMS "cases"
        "complete -- modes st"
        "modes paper --count 2"
        "criterion paper --set excitation.duration=0.1"
        "respond paper --hz 25 --amplitude 1e-3 --duration 0.02 --output history.csv --events events.csv"
        "respond paper --method event-driven --hz 25 --amplitude 1e-3 --duration 0.02 --output event-driven.csv"
        "respond paper --method closed-form --duration 0.02 --output closed-form.csv"
        "map paper --x frequency=10:20:3 --y amplitude=1e-4:1e-3:2 --set excitation.duration=0.1 --output map.csv"
        "map paper --method fe --x frequency=10:20:2 --y amplitude=1e-4:1e-3:2 --set excitation.duration=0.01 --output fe-map.csv"
        "design paper --band 20:20 --length 1.9:2 --force 490:500 --duration 0.1"
        "animate paper --duration 0.02 --frames 2 --output film"
        "reference show stick-frequencies"
        "reference export stick-frequencies --output mine.csv"
        "compare stick-frequencies mine.csv --json verdict.json --junit verdict.xml --figure verdict.png"
        "report --only fig2 --output figures"
        "respond nowhere.toml")
  separate_arguments(arguments UNIX_COMMAND "${command}")
  execute_process(
    COMMAND ${VALGRIND} --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite ${PROGRAM} ${arguments}
    WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE status
    OUTPUT_QUIET
    ERROR_VARIABLE errors)
  set(expected 0)
  if(command STREQUAL "respond nowhere.toml")
    set(expected 2)
  endif()
  if(NOT status EQUAL expected)
    message(SEND_ERROR "stickslip ${command}: ended with ${status} instead of ${expected}\n${errors}")
  endif()
endforeach()
file(REMOVE_RECURSE ${FOLDER})
