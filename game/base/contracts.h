// base/contracts.h - say what must be true, and stop where it is not.
//
// EXPECTS names what a caller must have seen to, ENSURES what the function itself promises. A broken one is a
// programmer's mistake: with GLASSHOUSE_CONTRACTS (dev, sanitizer and test builds) it prints expression, file
// and line on stderr and traps. Without it nothing is evaluated. NDEBUG plays no part.
#pragma once

namespace gh {

// Prints one line on stderr and aborts.
[[noreturn]] void contract_violated(const char* kind, const char* expression, const char* file, int line);

}  // namespace gh

#ifdef GLASSHOUSE_CONTRACTS
#define GH_CONTRACT(kind, condition) \
    ((condition) ? static_cast<void>(0) : ::gh::contract_violated(kind, #condition, __FILE__, __LINE__))
#else
// sizeof keeps the expression compiled, so it can not rot, yet never evaluates it.
#define GH_CONTRACT(kind, condition) static_cast<void>(sizeof(!(condition)))
#endif

#define EXPECTS(condition) GH_CONTRACT("precondition", condition)
#define ENSURES(condition) GH_CONTRACT("postcondition", condition)
