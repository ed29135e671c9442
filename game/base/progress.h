// base/progress.h - how far a long piece of work has come, on stderr.
//
// On a terminal one line is redrawn in place; elsewhere (a log, a pipe) a plain line comes at every tenth
// part, so that logs stay short. Nothing reads a clock: it is drawn when the shown percentage changes.
// The line ends when all is done; whoever has something to say before that ends it first.
// Threads   one at a time.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace gh {

class Progress {
  public:
    // `total` 0 is shown as finished at once.
    Progress(std::string label, std::size_t total);
    // The same, drawn elsewhere: for tests.
    Progress(std::string label, std::size_t total, std::FILE* out, bool is_terminal);
    ~Progress();  // ends the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `done` of the total; more than the total counts as the total.
    void show(std::size_t done);
    // What is said next has a line of its own.
    void end_line();

  private:
    std::string label_;
    std::size_t total_;
    std::FILE* out_;
    bool is_terminal_;
    bool is_line_open_ = false;
    int shown_percent_ = -1;
};

}  // namespace gh
