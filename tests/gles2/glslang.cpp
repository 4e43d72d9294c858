#include "gles2/glslang.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <sys/wait.h>

#include "base/error.h"
#include "base/files.h"

namespace metamer::test {

namespace {

/// A folder that goes with this.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "metamer-glslang-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw failure("make", pattern, "no temporary folder");
        path_ = pattern;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

struct Answer {
    int status;
    std::string output;
};

Answer answer_of(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr)
        throw failure("run", command, "no pipe");
    Answer answer{0, ""};
    std::array<char, 4096> piece{};
    while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), pipe))
        answer.output.append(piece.data(), size);
    const int status = pclose(pipe);
    answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return answer;
}

/// A command line holds 128 KiB on Linux (MAX_ARG_STRLEN): names of some tens of bytes, this many at once.
constexpr std::size_t kInputsAtOnce = 500;

/// glslangValidator over these inputs, each followed by `ending`.
Answer glslang_once(const std::string& options, std::span<const GlslangInput> inputs,
                    const std::string& ending) {
    const ScratchFolder folder;
    std::string names;
    for (const GlslangInput& input : inputs) {
        const std::string name = input.name + (input.stage == Stage::vertex ? ".vert" : ".frag");
        write_file(folder.path() / name, input.text + ending);
        names += " " + name;
    }
    return answer_of("cd '" + folder.path().string() + "' && glslangValidator " + options + names);
}

/// The same over any number; the status is that of the first that is not 0.
Answer glslang(const std::string& options, std::span<const GlslangInput> inputs, const std::string& ending) {
    if (answer_of("glslangValidator --version").status != 0)
        throw failure("run", "glslangValidator", "not installed (Debian: apt install glslang-tools)");
    Answer all{0, ""};
    for (std::size_t at = 0; at < inputs.size(); at += kInputsAtOnce) {
        const Answer answer =
            glslang_once(options, inputs.subspan(at, std::min(kInputsAtOnce, inputs.size() - at)), ending);
        all.status = all.status != 0 ? all.status : answer.status;
        all.output += answer.output;
    }
    return all;
}

} // namespace

std::string glslang_complaints(const std::vector<GlslangInput>& inputs) {
    const Answer answer = glslang("'" METAMER_SOURCE_DIR "/tests/gles2/es2_limits.conf'", inputs, "");
    return answer.status == 0 ? "" : answer.output;
}

std::vector<std::string> glslang_preprocessed(const std::vector<GlslangInput>& inputs) {
    const std::string ending = "metamer_ends_here";
    const Answer answer = glslang("-E", inputs, "\n" + ending + "\n");
    if (answer.status != 0)
        throw failure("preprocess", "shaders", answer.output);
    std::vector<std::string> texts;
    std::size_t start = 0;
    for (std::size_t end = 0; (end = answer.output.find(ending, start)) != std::string::npos;
         start = end + ending.size())
        texts.push_back(answer.output.substr(start, end - start));
    if (texts.size() != inputs.size())
        throw failure("preprocess", "shaders", answer.output);
    return texts;
}

} // namespace metamer::test
