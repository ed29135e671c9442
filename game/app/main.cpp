// glasshouse: play, replay, render, inspect.
#include "app/commands.h"
#include "app/options.h"

#include <exception>
#include <iostream>
#include <variant>

namespace {

template <class... Cases>
struct Match : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

int run(int argc, char** argv) {
    const std::variant<gh::app::Options, int> parsed = gh::app::parse_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
    return std::visit(Match{[](const gh::app::PlayOptions& o) { return gh::app::play(o); },
                            [](const gh::app::ReplayOptions& o) { return gh::app::replay(o); },
                            [](const gh::app::RenderOptions& o) { return gh::app::render(o); },
                            [](const gh::app::InspectOptions& o) { return gh::app::inspect(o); }},
                      std::get<gh::app::Options>(parsed));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {  // memory, or a library's own exception: none of ours
        std::cerr << "glasshouse: " << error.what() << '\n';
        return gh::app::kExitUnusable;
    }
}
