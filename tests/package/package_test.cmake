# Installs the package, builds the project beside this file against it, and runs that as its author would: cmake
# -DBUILD=FOLDER -DWORK=FOLDER -DCOMPILER=... -DLAUNCHER=... -DFLAGS=... -P package_test.cmake
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} gave ${status}:\n${words}")
  endif()
endfunction()

# expect(STATUS WORDS PROGRAM VARIABLE=VALUE...): how the program must end, and what it must say.
function(expect status words program)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=CI --unset=PROOFREEL_BLESS PROOFREEL_GOLDEN=${WORK}/golden ${ARGN}
      ${WORK}/build/${program}
    RESULT_VARIABLE status_now OUTPUT_VARIABLE words_now ERROR_VARIABLE words_now)
  string(REGEX REPLACE "[ \n]+" " " words_now "${words_now}")  # Catch2 breaks lines
  if(NOT status_now EQUAL status OR NOT words_now MATCHES "${words}")
    message(FATAL_ERROR "${program} ${ARGN}: expected ${status} and \"${words}\",\nnot ${status_now}:\n${words_now}")
  endif()
endfunction()

function(expect_file path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "There is no ${path}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
must(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_CXX_FLAGS=${FLAGS})
must(${CMAKE_COMMAND} --build ${WORK}/build)

foreach(program with_catch2 without_framework)
  file(REMOVE_RECURSE ${WORK}/golden ${WORK}/report)
  expect(1 "missing:? there is no reference" ${program})
  expect(2 "does not work with CI=true" without_framework PROOFREEL_BLESS=1 CI=true)
  if(EXISTS ${WORK}/golden)
    message(FATAL_ERROR "References were written without being blessed")
  endif()
  expect(0 "" ${program} PROOFREEL_BLESS=1)
  expect_file(${WORK}/golden/art/gradient.png)
  expect(0 "" ${program})
  expect(1 "drawing:? 64 of 6144 pixels differ, by up to 135 of 255 .at 40,24.*PROOFREEL_BLESS=1" ${program}
    BREAK_IT=1 PROOFREEL_REPORT=${WORK}/report)
  expect_file(${WORK}/report/index.html)
  expect_file(${WORK}/report/pictures/art/gradient/picture-heat.png)
endforeach()
file(COPY_FILE ${WORK}/golden/art/gradient.png ${WORK}/golden/old.png)
expect(1 "orphan nobody asked for .*old.png" without_framework)
