#include "bench_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace bench {

namespace {

constexpr int kNameWidth = 34;
constexpr int kLeastWidth = 13;

std::string with_decimals(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof(text), "%.*f", decimals, value);
    return text;
}

}  // namespace

struct Report::Impl {
    nlohmann::ordered_json all = nlohmann::ordered_json::object();
    std::vector<std::string> columns;
    std::vector<int> widths;
    std::size_t cell = 0;

    nlohmann::ordered_json& table() { return all["tables"].back(); }

    void add(const std::string& printed, nlohmann::ordered_json&& value) {
        if (cell >= columns.size()) return;
        std::printf(" %*s", widths[cell], printed.c_str());
        table()["rows"].back()[columns[cell]] = std::move(value);
        if (++cell == columns.size()) {
            std::printf("\n");
            std::fflush(stdout);
        }
    }
};

Report::Report() : impl_(std::make_unique<Impl>()) {
    impl_->all["facts"] = nlohmann::ordered_json::object();
    impl_->all["tables"] = nlohmann::ordered_json::array();
}
Report::~Report() = default;

void Report::table(const std::string& title, const std::string& of_rows, std::vector<std::string> columns) {
    impl_->all["tables"].push_back({{"title", title},
                                    {"rows", nlohmann::ordered_json::array()},
                                    {"notes", nlohmann::ordered_json::array()}});
    std::printf("\n%s\n%-*s", title.c_str(), kNameWidth, of_rows.c_str());
    impl_->widths.clear();
    for (const std::string& column : columns) {
        impl_->widths.push_back(std::max(kLeastWidth, static_cast<int>(column.size())));
        std::printf(" %*s", impl_->widths.back(), column.c_str());
    }
    std::printf("\n");
    impl_->columns = std::move(columns);
    impl_->cell = 0;
}

Report& Report::row(const std::string& name) {
    std::printf("%-*s", kNameWidth, name.c_str());
    impl_->table()["rows"].push_back({{"name", name}});
    impl_->cell = 0;
    return *this;
}

Report& Report::number(double value, int decimals) {
    impl_->add(with_decimals(value, decimals), value);
    return *this;
}

Report& Report::count(std::uint64_t value) {
    impl_->add(std::to_string(value), value);
    return *this;
}

Report& Report::text(const std::string& value) {
    impl_->add(value, value);
    return *this;
}

Report& Report::hash(std::uint64_t value) {
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(value));
    return text(digits);
}

Report& Report::none() {
    impl_->add("-", nullptr);
    return *this;
}

Report& Report::spread(const Samples& samples, int decimals) {
    const double low = samples.at(0.25), median = samples.at(0.5), high = samples.at(0.75);
    impl_->add(with_decimals(median, decimals) + " [" + with_decimals(low, decimals) + " " +
                   with_decimals(high, decimals) + "]",
               {{"median", median}, {"quartiles", {low, high}}});
    return *this;
}

Report& Report::speed(const Samples& samples, const Samples& ratios) {
    impl_->add(with_decimals(samples.at(0.5), 2) + " (" + with_decimals(ratios.at(0.5), 2) + ")",
               {{"median", samples.at(0.5)},
                {"quartiles", {samples.at(0.25), samples.at(0.75)}},
                {"ratio", ratios.at(0.5)},
                {"ratio_quartiles", {ratios.at(0.25), ratios.at(0.75)}}});
    return *this;
}

void Report::note(const std::string& sentence) {
    std::printf("%s\n", sentence.c_str());
    impl_->table()["notes"].push_back(sentence);
}

void Report::fact(const std::string& name, const std::string& value) {
    std::printf("%s: %s\n", name.c_str(), value.c_str());
    impl_->all["facts"][name] = value;
}

bool Report::write_json(const std::string& path) const {
    std::ofstream file(path);
    file << impl_->all.dump(1) << '\n';
    if (file.flush()) return true;
    std::fprintf(stderr, "%s: can not be written\n", path.c_str());
    return false;
}

}  // namespace bench
