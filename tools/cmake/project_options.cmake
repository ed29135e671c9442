# The one INTERFACE target everybody links: language, warnings, determinism, contracts, sanitizers.
option(GLASSHOUSE_DEV "contracts and library assertions on" OFF)
option(GLASSHOUSE_WERROR "warnings are errors" OFF)
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
if(GLASSHOUSE_SANITIZE)
    target_compile_options(project_options INTERFACE -fsanitize=${GLASSHOUSE_SANITIZE} -fno-sanitize-recover=all -O1
        -fno-omit-frame-pointer)
    target_link_options(project_options INTERFACE -fsanitize=${GLASSHOUSE_SANITIZE})
endif()
