/* count.c - a QEMU plugin: how many instructions a board executes from one address to another.
 *
 *     -plugin count.so,from=0xADDRESS,to=0xADDRESS,out=FILE
 *
 * Counting begins anew whenever `from` is executed; at the first `to` after it the count goes to FILE and the run ends.
 * Interrupts are counted, too. Written against the plugin interface of QEMU 7.2, as scope.c. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))
typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
struct qemu_info;
enum { NO_REGISTERS, ADD_U64 = 0 };
extern void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t,
                                                  void (*)(qemu_plugin_id_t, struct qemu_plugin_tb *));
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);
extern void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int op, void *ptr, uint64_t imm);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, void (*)(unsigned, void *), int flags,
                                                   void *);
extern void qemu_system_shutdown_request(int cause);

EXPORT int qemu_plugin_version = 1;

static uint64_t from, to, count;
static bool counting;
static FILE *out;

static void begin(unsigned cpu, void *unused) {
    (void)cpu, (void)unused;
    count = 0;
    counting = true;
}

static void end(unsigned cpu, void *unused) {
    (void)cpu, (void)unused;
    if (!counting) return;
    counting = false;
    fprintf(out, "%llu\n", (unsigned long long)count);
    fflush(out);
    qemu_system_shutdown_request(3);
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb) {
    (void)id;
    for (size_t k = 0; k < qemu_plugin_tb_n_insns(tb); k++) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, k);
        const uint64_t at = qemu_plugin_insn_vaddr(insn);
        qemu_plugin_register_vcpu_insn_exec_inline(insn, ADD_U64, &count, 1);
        if (at == from) qemu_plugin_register_vcpu_insn_exec_cb(insn, begin, NO_REGISTERS, NULL);
        if (at == to) qemu_plugin_register_vcpu_insn_exec_cb(insn, end, NO_REGISTERS, NULL);
    }
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv);
EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv) {
    (void)info;
    for (int k = 0; k < argc; k++) {
        if (strncmp(argv[k], "from=", 5) == 0) from = strtoull(argv[k] + 5, NULL, 0);
        if (strncmp(argv[k], "to=", 3) == 0) to = strtoull(argv[k] + 3, NULL, 0);
        if (strncmp(argv[k], "out=", 4) == 0) out = fopen(argv[k] + 4, "w");
    }
    if (!from || !to || !out) return -1;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    return 0;
}
