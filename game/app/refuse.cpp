#include "app/commands.h"
#include "app/printable.h"

#include <iostream>

namespace gh::app {

int refuse(const Error& error) {
    std::cerr << "glasshouse: " << printable(error.sentence) << '\n';
    return kExitUnusable;
}

void apply(const MachineOptions& machine) {
    if (machine.isa) rc::use_isa(*machine.isa);  // options.cpp refused what this machine lacks
}

}  // namespace gh::app
