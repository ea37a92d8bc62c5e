# Runs a program and judges it:
#
#   cmake -DEXIT=<code> -DSTDOUT=<regex> -DSTDERR=<regex> -P gatunRunCli.cmake -- <program> <args>
set(command)
set(in_command FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach (i RANGE ${last})
  if (in_command)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif (CMAKE_ARGV${i} STREQUAL "--")
    set(in_command TRUE)
  endif ()
endforeach ()

execute_process(COMMAND ${command}
  RESULT_VARIABLE code
  OUTPUT_VARIABLE out
  ERROR_VARIABLE  err)
message("exit ${code}\n--- stdout\n${out}--- stderr\n${err}---")

if (NOT code STREQUAL EXIT)
  message(FATAL_ERROR "The exit code is ${code}, not ${EXIT}.")
endif ()
if (NOT STDOUT STREQUAL "" AND NOT out MATCHES "${STDOUT}")
  message(FATAL_ERROR "stdout does not match ${STDOUT}")
endif ()
if (NOT STDERR STREQUAL "" AND NOT err MATCHES "${STDERR}")
  message(FATAL_ERROR "stderr does not match ${STDERR}")
endif ()
