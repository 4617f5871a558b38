#include "mres/gl/program.h"

#include <regex>
#include <stdexcept>

#include "mres/gl/label.h"

namespace mres::gl {
namespace {

/// Owns a shader object until the program is linked.
class Shader {
 public:
  explicit Shader(GLenum stage) : id_(glCreateShader(stage)) {}
  ~Shader() { glDeleteShader(id_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_;
};

template <class GetParameter, class GetLog>
std::string infoLog(GLuint id, GetParameter getParameter, GetLog getLog) {
  GLint length = 0;
  getParameter(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  if (length > 0) getLog(id, length, nullptr, log.data());
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
  return log;
}

/// Compilers write "1:23(4): error" (Mesa, Intel) or "1(23) : error" (NVIDIA) where 1 is the string number.
std::string withFileNames(const std::string& log, const std::vector<std::string>& fileNames) {
  static const std::regex kPlace(R"((^|\n|ERROR: |WARNING: )(\d+)([:(])(\d+))");
  std::string mapped;
  auto rest = log.cbegin();
  for (std::sregex_iterator match(log.begin(), log.end(), kPlace), end; match != end; ++match) {
    mapped.append(rest, (*match)[0].first);
    const std::size_t file = std::stoul((*match)[2].str());
    mapped += (*match)[1].str() + (file < fileNames.size() ? fileNames[file] : (*match)[2].str()) +
              (*match)[3].str() + (*match)[4].str();
    rest = (*match)[0].second;
  }
  return mapped.append(rest, log.cend());
}

void compile(const Shader& shader, const ShaderLibrary& library, const std::string& name,
             const std::string& defines) {
  const PreprocessedShader source = preprocess(library, name, defines);
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    throw std::runtime_error(
        "Shader '" + name + "' does not compile: " +
        withFileNames(infoLog(shader.id(), glGetShaderiv, glGetShaderInfoLog), source.fileNames));
  }
}

}  // namespace

Program::Program(const ShaderLibrary& library, const Sources& sources) : name_(ProgramName::create()) {
  const Shader vertex(GL_VERTEX_SHADER);
  const Shader fragment(GL_FRAGMENT_SHADER);
  compile(vertex, library, sources.vertex, sources.defines);
  compile(fragment, library, sources.fragment, sources.defines);
  glAttachShader(id(), vertex.id());
  glAttachShader(id(), fragment.id());
  glLinkProgram(id());
  glDetachShader(id(), vertex.id());
  glDetachShader(id(), fragment.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(id(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    throw std::runtime_error("Shaders '" + sources.vertex + "' and '" + sources.fragment +
                             "' do not link: " + infoLog(id(), glGetProgramiv, glGetProgramInfoLog));
  }
  setLabel(GL_PROGRAM, id(), sources.fragment.c_str());
}

void Program::setTextureUnit(const char* name, GLint unit) const {
  if (const GLint location = uniformLocation(name); location >= 0) glUniform1i(location, unit);
}

void Program::setBlockBinding(const char* name, GLuint binding) const {
  if (const GLuint index = glGetUniformBlockIndex(id(), name); index != GL_INVALID_INDEX) {
    glUniformBlockBinding(id(), index, binding);
  }
}

GLint Program::uniformLocation(const char* name) const {
  return glGetUniformLocation(id(), name);
}

}  // namespace mres::gl
