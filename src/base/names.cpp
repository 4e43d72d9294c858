#include "base/names.h"

#include <algorithm>

namespace metamer {

namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j)
        d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i)
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

} // namespace

std::string lower_case(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

bool same_name(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> pieces;
    if (trimmed(text).empty())
        return pieces;
    for (;;) {
        const std::size_t at = text.find(separator);
        pieces.emplace_back(trimmed(text.substr(0, at)));
        if (at == std::string_view::npos)
            return pieces;
        text.remove_prefix(at + 1);
    }
}

std::string nearest_name(std::string_view typed, std::span<const std::string> candidates) {
    // A name of hundreds of letters is no slip of the finger, and the table grows with its square.
    if (typed.empty() || typed.size() > 64)
        return {};
    const std::string wanted = lower_case(typed);
    std::string best;
    std::size_t least = wanted.size() / 2 + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t d = distance(wanted, lower_case(candidate));
        if (d < least) {
            least = d;
            best = candidate;
        }
    }
    return best;
}

std::string listed(std::span<const std::string> names) {
    constexpr std::size_t kMost = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
        text += (i > 0 ? ", " : "") + names[i];
    if (names.size() > kMost)
        text += " and " + std::to_string(names.size() - kMost) + " more";
    return text;
}

std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates) {
    const std::string nearest = nearest_name(typed, candidates);
    return nearest.empty() ? std::string() : "; did you mean \"" + nearest + "\"?";
}

} // namespace metamer
