# Installs raycore below WORK, builds the example against it and nothing else, runs it, and compiles each header alone.
function(run what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(failed)
        message(FATAL_ERROR "${what} failed:\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run("install" ${CMAKE_COMMAND} --install ${BUILD} --component raycore --prefix ${WORK}/prefix)

set(flags "")
if(SANITIZE)
    set(flags "-fsanitize=${SANITIZE}")
endif()
run("configure" ${CMAKE_COMMAND} -S ${SOURCE}/raycore/example -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_FLAGS=${flags})
run("build" ${CMAKE_COMMAND} --build ${WORK}/build)
run("the example" ${WORK}/build/raycore_example)
# The plate is a quarter of the table's width, half way up to the lamp: its shadow is half as wide, a quarter of it.
if(NOT output MATCHES "lit ([0-9]+) of ([0-9]+)")
    message(FATAL_ERROR "the example says:\n${output}")
endif()
if(CMAKE_MATCH_1 LESS 1 OR NOT CMAKE_MATCH_1 LESS CMAKE_MATCH_2)
    message(FATAL_ERROR "a plate over a table leaves part of it dark, but the example says:\n${output}")
endif()

file(GLOB headers ${WORK}/prefix/include/raycore/*.h)
list(LENGTH headers count)
if(count LESS 7)
    message(FATAL_ERROR "only ${count} headers installed")
endif()
foreach(header IN LISTS headers)
    get_filename_component(name ${header} NAME)
    file(WRITE ${WORK}/alone.cpp "#include <raycore/${name}>\n#include <raycore/${name}>\nint main() {}\n")
    run("${name} alone" ${CXX} -std=c++20 -fsyntax-only -Wall -Wextra -Wconversion -Wpedantic -Wshadow -Werror
        -I${WORK}/prefix/include ${WORK}/alone.cpp)
endforeach()
