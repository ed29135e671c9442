// base/jobs.h - many threads on many independent items.
//
// Same bits an item writes to its own slot only and reads nothing another item writes; then the result does
//           not depend on the number of threads. Sums over items are made afterwards, in index order.
// Threads   run() may be called from inside an item. Nothing outside Jobs needs to know about threads, yet
//           parallel builders (raycore's) called through run_in obey its number as well.
// Cost      starting: a fraction of a microsecond when the threads are awake. An item: one indirect call.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace gh {

class Jobs {
  public:
    // 0: one thread for every core there is. Otherwise exactly that many, even on a smaller machine.
    explicit Jobs(int threads = 0);
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    [[nodiscard]] int threads() const;

    // Calls item(index, worker) once for every index in [0, count), in any order and on any of the threads,
    // and returns when all are done. `worker` is in [0, threads()): no two items that run at the same time
    // share it, so it may pick scratch memory, but never anything the result depends on.
    void run(std::size_t count, const std::function<void(std::size_t index, int worker)>& item) const;

    // Calls `work` on this thread such that parallel loops inside it use these threads.
    void run_in(const std::function<void()>& work) const;

  private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

}  // namespace gh
