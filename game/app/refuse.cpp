#include "app/commands.h"
#include "app/printable.h"

#include <algorithm>
#include <iostream>

namespace gh::app {

int refuse(const Error& error) {
    std::cerr << "glasshouse: " << printable(error.sentence) << '\n';
    return kExitUnusable;
}

void tell(const world::Level& level) {
    constexpr std::size_t kMostTold = 20;
    const std::size_t count = std::min(level.remarks.size(), kMostTold);
    for (std::size_t i = 0; i < count; ++i)
        std::cerr << "glasshouse: " << printable(level.name + ": " + level.remarks[i]) << '\n';
    if (level.remarks.size() > count)
        std::cerr << "glasshouse: " << printable(level.name) << ": and " << level.remarks.size() - count
                  << " more, which inspect lists\n";
}

void apply(const MachineOptions& machine) {
    if (machine.isa) rc::use_isa(*machine.isa);  // options.cpp refused what this machine lacks
}

}  // namespace gh::app
