#include "gles2/source_facts.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace metamer::test {

namespace {

bool of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

bool whole_number(const std::string& token) {
    return !token.empty() &&
           std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool precision(const std::string& token) {
    return token == "lowp" || token == "mediump" || token == "highp";
}

/// The token at `at`, an empty one behind the end.
const std::string& token_at(const std::vector<std::string>& tokens, std::size_t at) {
    static const std::string none;
    return at < tokens.size() ? tokens[at] : none;
}

/// Whether the tokens from `at` on are ( int i = NUMBER ; i < NUMBER ; i + + ).
bool constant_loop(const std::vector<std::string>& tokens, std::size_t at) {
    const std::string& index = token_at(tokens, at + 2);
    const std::array<std::string, 14> form = {"(", "int", index, "=",   "",  ";", index,
                                              "<", "",    ";",   index, "+", "+", ")"};
    for (std::size_t i = 0; i < form.size(); ++i) {
        const std::string& token = token_at(tokens, at + i);
        if (form[i].empty() ? !whole_number(token) : token != form[i])
            return false;
    }
    return true;
}

/// Names separated by commas, up to the semicolon at the end.
void add_names(const std::vector<std::string>& tokens, std::size_t at, Declaration declaration,
               std::vector<Declaration>& out) {
    while (at < tokens.size() && tokens[at] != ";") {
        declaration.name = tokens[at++];
        declaration.size = 1;
        if (token_at(tokens, at) == "[") {
            declaration.size = std::stoi(token_at(tokens, at + 1));
            at += 3;
        }
        out.push_back(declaration);
        if (token_at(tokens, at) == ",")
            ++at;
    }
}

} // namespace

std::vector<std::string> tokens(std::string_view preprocessed) {
    std::vector<std::string> found;
    for (std::size_t at = 0; at < preprocessed.size();) {
        std::size_t end = at + 1;
        if (of_word(preprocessed[at]))
            while (end < preprocessed.size() && of_word(preprocessed[end]))
                ++end;
        if (std::isspace(static_cast<unsigned char>(preprocessed[at])) == 0)
            found.emplace_back(preprocessed.substr(at, end - at));
        at = end;
    }
    return found;
}

std::vector<Declaration> declarations(const std::vector<std::string>& tokens) {
    std::vector<Declaration> found;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] != "uniform" && tokens[i] != "varying" && tokens[i] != "attribute")
            continue;
        const std::size_t type = precision(token_at(tokens, i + 1)) ? i + 2 : i + 1;
        add_names(tokens, type + 1, {tokens[i], token_at(tokens, type), "", 1}, found);
    }
    return found;
}

int vectors(const std::vector<Declaration>& declarations, std::string_view qualifier) {
    int count = 0;
    for (const Declaration& declaration : declarations)
        if (declaration.qualifier == qualifier && !declaration.is_sampler())
            count +=
                declaration.size * (declaration.type.starts_with("mat") ? declaration.type.at(3) - '0' : 1);
    return count;
}

int samplers(const std::vector<Declaration>& declarations) {
    int count = 0;
    for (const Declaration& declaration : declarations)
        count += declaration.is_sampler() ? declaration.size : 0;
    return count;
}

std::vector<std::string> broken_rules(Stage stage, const std::vector<std::string>& tokens) {
    static const std::vector<std::string> never = {"while", "do", "dFdx", "dFdy", "fwidth", "extension"};
    std::vector<std::string> broken;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string& token = tokens[i];
        const bool texture = token.starts_with("texture") && token_at(tokens, i + 1) == "(";
        if (std::find(never.begin(), never.end(), token) != never.end())
            broken.push_back(token + " is not for the oldest GPUs");
        if (token == "for" && !constant_loop(tokens, i + 1))
            broken.push_back("a loop is not for (int i = NUMBER; i < NUMBER; i++)");
        if (texture &&
            (token.ends_with("Lod") || token.ends_with("LodEXT") || token.find("Grad") != token.npos))
            broken.push_back(token + " asks for a level of detail");
        if (texture && stage == Stage::vertex)
            broken.push_back(token + " in a vertex shader");
    }
    return broken;
}

} // namespace metamer::test
