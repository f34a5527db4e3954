/* csv.h - the CSV files of an example: prefix_name.csv; null, and nothing is written, without a prefix */
#ifndef CSV_H
#define CSV_H

#include <stdio.h>
#include <stdlib.h>

static inline FILE *csv_open(const char *prefix, const char *name)
{
    char path[300];
    FILE *file;
    if (!prefix) return NULL;
    snprintf(path, sizeof path, "%s_%s.csv", prefix, name);
    file = fopen(path, "w");
    if (!file) {
        fprintf(stderr, "cannot write %s\n", path);
        exit(1);
    }
    return file;
}

static inline void csv_close(FILE *file)
{
    if (file) fclose(file);
}

#endif
