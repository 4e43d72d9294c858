#include "gles/timer_query.h"

#include <EGL/egl.h>
#include <GLES2/gl2ext.h>
#include <utility>

#include "gles/extensions.h"

namespace metamer {

namespace {

struct Functions {
    PFNGLGENQUERIESEXTPROC gen_queries;
    PFNGLDELETEQUERIESEXTPROC delete_queries;
    PFNGLBEGINQUERYEXTPROC begin_query;
    PFNGLENDQUERYEXTPROC end_query;
    PFNGLGETQUERYIVEXTPROC get_query;
    PFNGLGETQUERYOBJECTUI64VEXTPROC get_object;

    bool all() const {
        return gen_queries && delete_queries && begin_query && end_query && get_query && get_object;
    }
};

template <class Function>
Function function(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// EGL gives one address for all contexts (EGL 1.5, section 3.12).
const Functions& gl() {
    static const Functions functions{function<PFNGLGENQUERIESEXTPROC>("glGenQueriesEXT"),
                                     function<PFNGLDELETEQUERIESEXTPROC>("glDeleteQueriesEXT"),
                                     function<PFNGLBEGINQUERYEXTPROC>("glBeginQueryEXT"),
                                     function<PFNGLENDQUERYEXTPROC>("glEndQueryEXT"),
                                     function<PFNGLGETQUERYIVEXTPROC>("glGetQueryivEXT"),
                                     function<PFNGLGETQUERYOBJECTUI64VEXTPROC>("glGetQueryObjectui64vEXT")};
    return functions;
}

bool disjoint() {
    GLint disjoint = GL_FALSE;
    glGetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint); // asking resets it
    return disjoint != GL_FALSE;
}

} // namespace

std::optional<TimerQuery> TimerQuery::create() {
    if (!use_gl_extension("GL_EXT_disjoint_timer_query") || !gl().all())
        return std::nullopt;
    GLint bits = 0;
    gl().get_query(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    if (bits == 0)
        return std::nullopt;
    GLuint query = 0;
    gl().gen_queries(1, &query);
    return TimerQuery(query);
}

TimerQuery::TimerQuery(TimerQuery&& other) noexcept : query_(std::exchange(other.query_, 0)) {}

TimerQuery& TimerQuery::operator=(TimerQuery&& other) noexcept {
    std::swap(query_, other.query_);
    return *this;
}

TimerQuery::~TimerQuery() {
    if (query_ != 0)
        gl().delete_queries(1, &query_);
}

void TimerQuery::begin() {
    disjoint();
    gl().begin_query(GL_TIME_ELAPSED_EXT, query_);
}

void TimerQuery::end() {
    gl().end_query(GL_TIME_ELAPSED_EXT);
}

std::optional<double> TimerQuery::elapsed_ms() {
    GLuint64 ns = 0;
    gl().get_object(query_, GL_QUERY_RESULT_EXT, &ns);
    if (disjoint())
        return std::nullopt;
    return static_cast<double>(ns) / 1e6;
}

} // namespace metamer
