# SPDX-License-Identifier: MIT
# The lint, one test a rule, and its negative controls. A missing tool skips a rule and says which.
find_package(Python3 3.9 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
  foreach(rule twins files headers borders builtins format shaders ptx oldest flags)
    add_test(NAME lint.${rule}
      COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/lint.py ${rule} --build ${PROJECT_BINARY_DIR})
    set_tests_properties(lint.${rule} PROPERTIES SKIP_RETURN_CODE 77)
  endforeach()
  add_test(NAME lint.controls
    COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/lint_controls.py ${PROJECT_BINARY_DIR} -v)
  # The first python3 in PATH need not be the one that matplotlib was installed for.
  set(figure_python ${Python3_EXECUTABLE})
  foreach(candidate ${Python3_EXECUTABLE} /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import matplotlib, numpy" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(NOT failed)
      set(figure_python ${candidate})
      break()
    endif()
  endforeach()
  add_test(NAME paper.figures COMMAND ${figure_python} -B ${CMAKE_CURRENT_LIST_DIR}/test_figures.py)
  set_tests_properties(paper.figures PROPERTIES SKIP_RETURN_CODE 77)
  add_test(NAME paper.numbers COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/test_paper.py)
  add_test(NAME paper.artifact COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/test_artifact.py)
  if(TARGET spherepair_bench)
    set(bench_program $<TARGET_FILE:spherepair_bench>)
  endif()
  add_test(NAME bench.sweep
    COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_LIST_DIR}/test_sweep.py $<TARGET_FILE:spherepair> ${bench_program})
else()
  message(WARNING "Python 3.9 or newer was not found: the lint and the paper's numbers are left out of the tests")
endif()
