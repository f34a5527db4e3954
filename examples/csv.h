/* csv.h - opens and closes the CSV files prefix_name.csv of an example. If prefix is NULL, no file is written. */
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
