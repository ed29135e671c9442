// contract.h - a programmer's mistake traps with a message where RC_CONTRACTS is defined; elsewhere the documented
// answer for bad input stands.
#pragma once

#ifdef RC_CONTRACTS
#include <cstdio>
#define RC_EXPECTS(condition, message)                                                        \
    do {                                                                                      \
        if (!(condition)) {                                                                   \
            std::fprintf(stderr, "%s:%d: raycore expects %s\n", __FILE__, __LINE__, message); \
            __builtin_trap();                                                                 \
        }                                                                                     \
    } while (false)
#else
#define RC_EXPECTS(condition, message) static_cast<void>(0)
#endif
