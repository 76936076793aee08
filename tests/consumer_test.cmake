# cmake -DBUILD=<build tree> -DSOURCE=<consumer> -DWORK=<folder to make> -DGENERATOR=<generator>
# -DCOMPILER=<C++ compiler> -DFLAGS=<its flags> -P: installs the library and builds and runs a program that
# finds it as a package.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result
                  OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
foreach(header kernel/point.h sculpt/reconstruct.h io/read_points.h)
  if(NOT EXISTS ${WORK}/prefix/include/tetsculpt/${header})
    message(FATAL_ERROR "${header} was not installed")
  endif()
endforeach()
foreach(file man/man1/tetsculpt.1 bash-completion/completions/tetsculpt)
  if(NOT EXISTS ${WORK}/prefix/share/${file})
    message(FATAL_ERROR "share/${file} was not installed")
  endif()
  file(READ ${WORK}/prefix/share/${file} text)
  if(NOT text MATCHES "dry")
    message(FATAL_ERROR "share/${file} does not know --dry-run")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER}
    "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
if(NOT text STREQUAL "6 triangles\n")
  message(FATAL_ERROR "the consumer says '${text}'")
endif()
