#include "base/jobs.h"

#include "base/contracts.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <thread>

#if defined(__SANITIZE_THREAD__)
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace gh {

namespace {

// Tells the thread sanitizer, which does not see into oneTBB's library, that what a thread did before giving is seen by
// whoever takes later. One place for all: captured variables could not be looked at before taking.
#if defined(__SANITIZE_THREAD__)
char handed_over;
void give() {
    __tsan_release(&handed_over);
}
void take() {
    __tsan_acquire(&handed_over);
}
#else
void give() {}
void take() {}
#endif

int core_count() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

struct Jobs::Arena {
    explicit Arena(int threads) : arena(threads) {
        // oneTBB never starts more threads than there are cores unless it is told to.
        if (threads > core_count()) {
            more_threads.emplace(tbb::global_control::max_allowed_parallelism,
                                 static_cast<std::size_t>(threads));
        }
    }

    std::optional<tbb::global_control> more_threads;
    tbb::task_arena arena;
};

Jobs::Jobs(int threads) {
    EXPECTS(threads >= 0);
    arena_ = std::make_unique<Arena>(threads > 0 ? threads : core_count());
}

Jobs::~Jobs() = default;

int Jobs::threads() const {
    return arena_->arena.max_concurrency();
}

void Jobs::run(std::size_t count, const std::function<void(std::size_t index, int worker)>& item) const {
    give();
    arena_->arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t index) {
            take();
            item(index, tbb::this_task_arena::current_thread_index());
            give();
        });
    });
    take();
}

void Jobs::run_in(const std::function<void()>& work) const {
    arena_->arena.execute(work);
}

}  // namespace gh
