#include "report/rows.h"

#include "report/field_csv.h"

namespace metamer {

std::string chart_csv(const Chart& chart) {
    return fields_csv(chart.context, chart.rows, "chart rows");
}

std::string chart_json(const Chart& chart) {
    return fields_json(chart.context, chart.rows, "chart rows");
}

Chart read_chart_csv(const std::string& text, const std::string& place) {
    Chart chart;
    read_fields_csv(text, place, chart.context, chart.rows, [](const ChartRow&, int) {});
    return chart;
}

} // namespace metamer
