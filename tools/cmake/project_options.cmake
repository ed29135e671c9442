# The one INTERFACE target everybody links: language, warnings, determinism, contracts, sanitizers.
option(GLASSHOUSE_DEV "contracts and library assertions on" OFF)
option(GLASSHOUSE_WERROR "warnings are errors" OFF)
option(GLASSHOUSE_UNITY "compile the sources of a library together" OFF)
set(GLASSHOUSE_SANITIZE "" CACHE STRING "comma-separated sanitizers, e.g. address,undefined")

add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
target_compile_options(project_options INTERFACE
    # Bits must not depend on the compiler's mood: no contraction, no fast-math, never -march=native.
    -ffp-contract=off -fno-fast-math -fno-math-errno
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wold-style-cast -Wcast-align
    -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Wformat=2 -Wundef -Wmissing-declarations)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(project_options INTERFACE -Wduplicated-cond -Wlogical-op -Wsuggest-override)
endif()
if(GLASSHOUSE_WERROR)
    target_compile_options(project_options INTERFACE -Werror)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # At -O3 GCC 12 sees overlaps and overflows in plain std::string and std::vector code (its bugs 105651, 105329).
        target_compile_options(project_options INTERFACE -Wno-restrict -Wno-error=stringop-overflow
            -Wno-error=array-bounds)
    endif()
endif()
target_compile_definitions(project_options INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_FORCE_SIZE_T_LENGTH)
if(GLASSHOUSE_DEV)
    target_compile_definitions(project_options INTERFACE GLASSHOUSE_CONTRACTS RC_CONTRACTS _GLIBCXX_ASSERTIONS)
endif()
if(GLASSHOUSE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(project_options INTERFACE -Wno-subobject-linkage)  # of unnamed namespaces of included sources
endif()
if(GLASSHOUSE_SANITIZE)
    target_compile_options(project_options INTERFACE -fsanitize=${GLASSHOUSE_SANITIZE} -fno-sanitize-recover=all -O1
        -fno-omit-frame-pointer)
    target_link_options(project_options INTERFACE -fsanitize=${GLASSHOUSE_SANITIZE})
endif()

# With GLASSHOUSE_UNITY a target's sources are compiled sixteen at a time, as one, since most of the time goes to headers:
# for builds from scratch, not for working in. So no two sources of a target may say the same name in their unnamed
# namespaces. Left alone: sources with flags of their own (CMake sees to that), and those that Highway compiles once for
# every instruction set by including them again.
function(put_sources_together target)
    if(NOT GLASSHOUSE_UNITY)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source)
        file(STRINGS ${source} includes_itself REGEX "HWY_TARGET_INCLUDE" LIMIT_COUNT 1)
        if(includes_itself)
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
endfunction()
