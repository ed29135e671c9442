// app/printable.h - text from damaged files made fit for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace gh::app {

// `text` with every byte that is not well-formed UTF-8, and every control character but the line feed, as '?'.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace gh::app
