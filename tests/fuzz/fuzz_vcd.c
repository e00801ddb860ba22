/* Arbitrary text as a Value Change Dump: it must be read or refused, judged and compared without a fault.
 * The trace library belongs to the host and is not in the core that fuzz targets link, so its files are named here. */
#include "host/trace_compare.c"
#include "host/trace_judge.c"
#include "host/trace_path.c"
#include "host/trace_place.c"
#include "host/trace_read.c"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    trace_t t;
    trace_error_t error;
    if (trace_read_text((const char *)data, size, &t, &error)) return 0;
    trace_difference_t d;
    trace_compare(&t, &t, 1, true, &d);
    if (!d.same_sequence || d.max_us != 0) abort();
    trace_judgement_t j;
    trace_judge(&t, &t.machine, &j);
    trace_free(&t);
    return 0;
}
