#include "gles/shader_source.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>

#include "base/error.h"
#include "base/names.h"

namespace metamer {

namespace {

/// Lines of one file, and what of each is comment.
class LineReader {
public:
    explicit LineReader(std::string_view text) : rest_(text) {}

    bool next() {
        if (rest_.empty())
            return false;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        if (line_.ends_with('\r'))
            line_.remove_suffix(1);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        strip_comments();
        return true;
    }
    std::string_view line() const { return line_; }
    std::string_view code() const { return trimmed(code_); } ///< the line without its comments
    int number() const { return number_; }
    bool in_comment() const { return in_comment_; }

private:
    void strip_comments() {
        code_.clear();
        for (std::size_t i = 0; i < line_.size(); ++i) {
            const std::string_view two = line_.substr(i, 2);
            if (in_comment_ ? two == "*/" : two == "/*") {
                in_comment_ = !in_comment_;
                ++i;
                code_ += ' ';
            } else if (!in_comment_ && two == "//") {
                break;
            } else if (!in_comment_) {
                code_ += line_[i];
            }
        }
    }

    std::string_view rest_, line_;
    std::string code_;
    int number_ = 0;
    bool in_comment_ = false;
};

/// The words of a preprocessor line: `# include "x"` gives {include, "x"}; nothing for other lines.
struct Directive {
    std::string_view name, argument;
};

std::optional<Directive> directive(std::string_view code) {
    if (!code.starts_with('#'))
        return std::nullopt;
    code = trimmed(code.substr(1));
    const std::size_t end = std::min(code.find_first_of(" \t\"<("), code.size());
    return Directive{code.substr(0, end), trimmed(code.substr(end))};
}

/// The branches of #if that are open, outermost first, each under a number of its own.
using Branches = std::vector<int>;

class Composer {
public:
    Composer(const Defines& defines, const ShaderFiles& files) : defines_(defines), files_(files) {}

    ComposedShader compose(std::string_view file) {
        composed_.file = std::string(kShaderFolder) + std::string(file);
        const std::string_view text = files_(file);
        if (text.data() == nullptr || text.empty())
            throw failure("read", composed_.file, "no such shader file");
        expand(std::string(file), text);
        if (!defines_done_)
            put_defines();
        return std::move(composed_);
    }

private:
    void expand(const std::string& file, std::string_view text) {
        const std::string path = std::string(kShaderFolder) + file;
        const std::size_t outer_branches = branches_.size();
        open_.push_back(file);
        included_[file] = branches_;
        LineReader reader(text);
        while (reader.next()) {
            const std::string place = path + ":" + std::to_string(reader.number());
            take_line(reader, path, place);
        }
        if (reader.in_comment())
            throw failure("compose", path + ":" + std::to_string(reader.number()),
                          "a /* comment does not end");
        if (branches_.size() != outer_branches)
            throw failure("compose", path + ":" + std::to_string(reader.number()),
                          "an #if does not end in its file");
        open_.pop_back();
    }

    void take_line(const LineReader& reader, const std::string& path, const std::string& place) {
        const auto found = directive(reader.code());
        if (found && found->name == "version") {
            check_version(found->argument, place);
        } else if (!defines_done_ && !reader.code().empty()) {
            put_defines();
        }
        if (found && found->name == "include") {
            include(found->argument, place);
            return;
        }
        if (found)
            follow_branches(found->name, place);
        put(reader.line(), {path, reader.number()});
    }

    void check_version(std::string_view version, const std::string& place) const {
        if (version != "100")
            throw failure("compose", place, "#version " + std::string(version) + " is not 100");
        if (defines_done_ || open_.size() > 1)
            throw failure("compose", place, "#version must come before everything but comments");
    }

    void include(std::string_view argument, const std::string& place) {
        if (argument.size() < 3 || !argument.starts_with('"') || !argument.ends_with('"'))
            throw failure("compose", place, "#include takes a file name in double quotes");
        const std::string file(argument.substr(1, argument.size() - 2));
        for (const std::string& open : open_)
            if (open == file)
                throw failure("compose", place,
                              "#include \"" + file + "\" goes round in a circle: " + circle(file));
        if (const auto before = included_.find(file); before != included_.end()) {
            if (!reaches(before->second))
                throw failure("compose", place,
                              "\"" + file + "\" was included before under an #if that does not reach here");
            return;
        }
        const std::string_view text = files_(file);
        if (text.data() == nullptr || text.empty())
            throw failure("compose", place, "#include \"" + file + "\": no such shader file");
        expand(file, text);
    }

    /// Whether code in `there` is always seen where the branches open now are.
    bool reaches(const Branches& there) const {
        return there.size() <= branches_.size() && std::equal(there.begin(), there.end(), branches_.begin());
    }

    std::string circle(const std::string& file) const {
        std::string names;
        for (const std::string& open : open_)
            names += open + " > ";
        return names + file;
    }

    void follow_branches(std::string_view name, const std::string& place) {
        const bool opens = name == "if" || name == "ifdef" || name == "ifndef";
        const bool closes = name == "endif";
        const bool turns = name == "else" || name == "elif";
        if ((closes || turns) && branches_.empty())
            throw failure("compose", place, "#" + std::string(name) + " without #if");
        if (closes || turns)
            branches_.pop_back();
        if (opens || turns)
            branches_.push_back(++last_branch_);
    }

    void put_defines() {
        defines_done_ = true;
        for (const auto& [name, value] : defines_)
            put("#define " + name + " " + value, {composed_.file, 0});
    }

    void put(std::string_view line, ShaderLine origin) {
        composed_.text.append(line).push_back('\n');
        composed_.lines.push_back(std::move(origin));
    }

    const Defines& defines_;
    const ShaderFiles& files_;
    ComposedShader composed_;
    bool defines_done_ = false;
    std::vector<std::string> open_; ///< the file being read and those that include it, outermost first
    std::map<std::string, Branches> included_; ///< where each file was first expanded
    Branches branches_;
    int last_branch_ = 0;
};

std::string rewrite_line(const std::string& line, const ComposedShader& composed) {
    // ERROR: 0:12: what | 0:12(3): what or 0:12: what | 0(12) : what
    static const std::regex forms(R"(^(?:(ERROR|WARNING): )?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\)) ?: *(.*)$)",
                                  std::regex::icase);
    std::smatch match;
    if (!std::regex_match(line, match, forms))
        return line;
    const std::string number = match[2].matched ? match[2] : match[3];
    if (number.size() > 9)
        return line;
    const auto at = static_cast<std::size_t>(std::stoi(number));
    if (at < 1 || at > composed.lines.size())
        return line;
    const ShaderLine& origin = composed.lines[at - 1];
    const std::string kind = match[1].matched ? lower_case(match[1].str()) + ": " : "";
    return origin.file + ":" + std::to_string(origin.line) + ": " + kind + match[4].str();
}

} // namespace

ComposedShader compose_shader(std::string_view file, const Defines& defines, const ShaderFiles& files) {
    return Composer(defines, files).compose(file);
}

std::string rewrite_log(const std::string& driver_log, const ComposedShader& composed) {
    std::string rewritten;
    std::size_t start = 0;
    while (start < driver_log.size()) {
        const std::size_t end = std::min(driver_log.find('\n', start), driver_log.size());
        std::string_view line = std::string_view(driver_log).substr(start, end - start);
        while (!line.empty() && (line.back() == '\0' || trimmed(line.substr(line.size() - 1)).empty()))
            line.remove_suffix(1);
        if (!line.empty())
            rewritten += (rewritten.empty() ? "" : "\n") + rewrite_line(std::string(line), composed);
        start = end + 1;
    }
    return rewritten;
}

} // namespace metamer
