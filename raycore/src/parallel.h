// parallel.h - oneTBB's loops, sums and tasks, as the builders use them; no other file of raycore knows oneTBB.
//
// The thread sanitizer does not see into oneTBB's library: what was written before a loop looks to it like a race with
// what the loop reads. Here it is told what is handed over, and only that: two pieces of work that run side by side and
// touch the same are found. One address serves all, since captured variables could not be looked at before taking.
//
// Same bits: parts of a sum are joined in the order of their ranges, but where a range is cut is oneTBB's choice: sums must
// not depend on it (they are of boxes and whole numbers).
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_group.h>

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace rc {

#if defined(__SANITIZE_THREAD__)
inline char handed_over;
inline void give() {
    __tsan_release(&handed_over);
}
inline void take() {
    __tsan_acquire(&handed_over);
}
// What oneTBB keeps on the stack while it works is read by its threads after we took back what is ours. Another's frames
// there later would look like a race, so it stands where none will come.
template <class Call>
[[gnu::noinline]] void well_below(const Call& call) {
    [[maybe_unused]] volatile char gap[1 << 17];  // GCC 12 says that nobody uses what is written to it
    gap[0] = 0;
    call();
    gap[1] = 0;
}
#else
inline void give() {}
inline void take() {}
template <class Call>
void well_below(const Call& call) {
    call();
}
#endif

using BlockedRange = tbb::blocked_range<std::size_t>;

// body(i) for every i of [0, n).
template <class Index, class Body>
void for_in_parallel(Index n, const Body& body) {
    give();
    well_below([&] {
        tbb::parallel_for(Index{0}, n, [&](Index i) {
            take();
            body(i);
            give();
        });
    });
    take();
}

// body(part) for parts of a range that together are all of it.
template <class Body>
void for_in_parallel(const BlockedRange& all, const Body& body) {
    give();
    well_below([&] {
        tbb::parallel_for(all, [&](const BlockedRange& part) {
            take();
            body(part);
            give();
        });
    });
    take();
}

// The join of body(part, nothing) over parts of a range that together are all of it.
template <class Sum, class Body, class Join>
[[nodiscard]] Sum sum_in_parallel(const BlockedRange& all, const Sum& nothing, const Body& body,
                                  const Join& join) {
    Sum sum = nothing;
    give();
    well_below([&] {
        sum = tbb::parallel_reduce(
            all, nothing,
            [&](const BlockedRange& part, const Sum& before) {
                take();
                Sum after = body(part, before);
                give();
                return after;
            },
            [&](const Sum& a, const Sum& b) {
                take();
                Sum both = join(a, b);
                give();
                return both;
            });
    });
    take();
    return sum;
}

// Does both, side by side if there is a thread for it.
template <class One, class Other>
void both_in_parallel(const One& one, const Other& other) {
    tbb::task_group group;
    give();
    group.run([&] {
        take();
        one();
        give();
    });
    other();
    group.wait();
    take();
}

}  // namespace rc
