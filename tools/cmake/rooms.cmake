# A room is a folder of game/ and one static library: every .cpp in it but main.cpp, nothing else.
#   add_room(sense LINKS gh_world)      ->  library gh_sense from game/sense/*.cpp
#   add_room_tests(sense LABELS unit)   ->  program sense_tests from tests/sense/*.cpp, one ctest entry a test
# HEADERS are compiled once for all of a room's sources: for libraries whose headers take longer than the room itself.

function(add_room name)
    cmake_parse_arguments(ROOM "" "" "LINKS;PRIVATE;HEADERS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/game/${name}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    if(sources)
        add_library(gh_${name} STATIC ${sources})
        target_include_directories(gh_${name} PUBLIC ${CMAKE_SOURCE_DIR}/game)
        target_link_libraries(gh_${name} PUBLIC project_options ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE})
        put_sources_together(gh_${name})
        if(ROOM_HEADERS)
            target_precompile_headers(gh_${name} PRIVATE ${ROOM_HEADERS})
        endif()
    else()  # headers alone
        add_library(gh_${name} INTERFACE)
        target_include_directories(gh_${name} INTERFACE ${CMAKE_SOURCE_DIR}/game)
        target_link_libraries(gh_${name} INTERFACE project_options ${ROOM_LINKS})
    endif()
endfunction()

function(add_room_tests name)
    cmake_parse_arguments(T "" "" "LABELS;LINKS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${name}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(${name}_tests ${sources})
    target_link_libraries(${name}_tests PRIVATE project_options test_support GTest::gtest_main ${T_LINKS})
    target_compile_definitions(${name}_tests PRIVATE GLASSHOUSE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    target_precompile_headers(${name}_tests REUSE_FROM test_support)
    # A list of labels does not get through to CTest: all but the first would be lost. What CTest is asked for (-L threads)
    # is looked for within a label.
    list(JOIN T_LABELS "-" label)
    gtest_discover_tests(${name}_tests PROPERTIES LABELS "${label}" DISCOVERY_TIMEOUT 60)
endfunction()
