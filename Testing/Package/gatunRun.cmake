# run(<program> <argument>...) stops the script if the program fails.
function (run)
  list(JOIN ARGN " " text)
  message(STATUS "${text}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code)
  if (NOT code EQUAL 0)
    message(FATAL_ERROR "exit ${code}: ${text}")
  endif ()
endfunction ()
