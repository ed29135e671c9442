#include "bench_race.h"

#include <algorithm>
#include <cstdio>
#include <thread>

namespace bench {

namespace {

struct Lap {
    double ms = 0;  // of the slowest thread
    Answer answer;
};

// The rays in as many runs as there are threads, each run whole 8x8 tiles.
Lap run_lap(const Contestant& contestant, const RaySet& set, unsigned threads) {
    constexpr std::size_t kTile = 64;
    const std::size_t tiles = (set.rays.size() + kTile - 1) / kTile;
    std::vector<Lap> laps(threads);
    const auto run = [&](unsigned i) {
        const std::size_t begin = std::min(set.rays.size(), tiles * i / threads * kTile);
        const std::size_t end = std::min(set.rays.size(), tiles * (i + 1) / threads * kTile);
        const double start = thread_ms();
        laps[i].answer = contestant.ask(std::span(set.rays).subspan(begin, end - begin), set.any);
        laps[i].ms = thread_ms() - start;
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(run, i);
    run(0);
    for (std::thread& other : others) other.join();

    Lap all;
    for (const Lap& lap : laps) {
        all.ms = std::max(all.ms, lap.ms);
        all.answer.hits += lap.answer.hits;
        all.answer.hash = (all.answer.hash ^ lap.answer.hash) * 0x100000001B3u;
    }
    return all;
}

std::string brief(const Answer& answer) {
    char text[64];
    std::snprintf(text, sizeof(text), "%llu %08llx", static_cast<unsigned long long>(answer.hits),
                  static_cast<unsigned long long>(answer.hash >> 32));
    return text;
}

}  // namespace

RaceResult race(const std::vector<Contestant>& contestants, const std::vector<RaySet>& sets,
                const RaceOptions& options) {
    RaceResult result;
    result.speed.assign(contestants.size(), std::vector<Samples>(sets.size()));
    result.answers.assign(contestants.size(), std::vector<Answer>(sets.size()));
    for (std::size_t s = 0; s < sets.size(); ++s) {
        for (int round = 0; round < options.rounds; ++round) {
            for (std::size_t c = 0; c < contestants.size(); ++c) {
                const Lap lap = run_lap(contestants[c], sets[s], options.threads);
                result.speed[c][s].ms.push_back(static_cast<double>(sets[s].rays.size()) / lap.ms * 1e-3);
                result.answers[c][s] = lap.answer;
            }
        }
    }
    return result;
}

Samples ratio_of(const Samples& a, const Samples& b) {
    Samples ratio;
    for (std::size_t i = 0; i < std::min(a.ms.size(), b.ms.size()); ++i)
        ratio.ms.push_back(a.ms[i] / b.ms[i]);
    return ratio;
}

void report_race(Report& report, const std::string& title, const std::vector<Contestant>& contestants,
                 const std::vector<RaySet>& sets, const RaceResult& result, std::size_t reference) {
    const std::vector<std::string> columns = names_of(sets);
    report.table(title + ": Mrays/s (ratio to " + contestants[reference].name + ")", "who", columns);
    for (std::size_t c = 0; c < contestants.size(); ++c) {
        report.row(contestants[c].name);
        for (std::size_t s = 0; s < sets.size(); ++s)
            report.speed(result.speed[c][s], ratio_of(result.speed[c][s], result.speed[reference][s]));
    }
}

void report_answers(Report& report, const std::string& title, const std::vector<Contestant>& contestants,
                    const std::vector<RaySet>& sets, const RaceResult& result) {
    const std::vector<std::string> columns = names_of(sets);
    report.table(title + ": hits and hash of the answers", "who", columns);
    for (std::size_t c = 0; c < contestants.size(); ++c) {
        report.row(contestants[c].name);
        for (std::size_t s = 0; s < sets.size(); ++s) report.text(brief(result.answers[c][s]));
    }
}

}  // namespace bench
