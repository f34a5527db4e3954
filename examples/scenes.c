/* The machines of chapter 1 and the numerical examples of the dissertation as scenes. For each of them the program
   prints the end of its motion beside a reference value (from an integration with 36 digits or a closed form), and
   writes its curves.

   usage: scenes [file.csv]
   For each machine the program writes file_NAME.csv (t, then the state) and file_NAME_events.csv (the time and the
   index of each event). */
#include "scenes/chains.h"
#include "scenes/crane.h"
#include "scenes/dosing.h"
#include "scenes/excavator.h"
#include "scenes/luffing_crane.h"
#include "scenes/mechanism.h"
#include "scenes/mill.h"
#include "scenes/oscillators.h"
#include "scenes/reel.h"
#include "scenes/regulator.h"
#include "scenes/scoop.h"
#include "scenes/stator.h"
#include "scenes/turner.h"
#include "scenes/two_stages.h"
#include "scenes/vessel.h"
#include "scenes/wagon.h"
#include "scenes/weighing.h"
#include <stdio.h>

enum { POINTS = 800 };
static const char *file_name;
static int length; /* length of the file name without ".csv" */
static FILE *event_file;
static long event_counts[STAGE_EVENTS]; /* how often each event had happened when the last row was written */

/* Writes the events since the last row. Between two rows no event happens twice. */
static void write_events(const vm_scene *scene)
{
    int i;
    for (i = 0; i < scene->n_events; i++) {
        if (event_file && scene->events[i].count > event_counts[i])
            fprintf(event_file, "%.6g,%d\n", (double)scene->events[i].time, i);
        event_counts[i] = scene->events[i].count;
    }
}

static int write_row(vm_real t, const vm_real *y, vm_scene *scene, void *file)
{
    const int n = vm_scene_size(scene) - VM_BUDGET_STATES;
    int i;
    fprintf((FILE *)file, "%.6g", (double)t);
    for (i = 0; i < n; i++) fprintf((FILE *)file, ",%.6g", (double)y[i]);
    fputc('\n', (FILE *)file);
    write_events(scene);
    return 0;
}

/* Runs the scene to its end. Prints the time and the number y[i] of the state at the end, with the reference values in
   parentheses. */
static void play(stage *s, const char *name, const char *what, int i, double wanted_t, double wanted)
{
    vm_real times[POINTS];
    char path[256];
    FILE *file = NULL;
    int k, status;
    memset(event_counts, 0, sizeof event_counts);
    for (k = 0; k < POINTS; k++) times[k] = (vm_real)wanted_t * (vm_real)k / (POINTS - 1);
    sprintf(path, "%.*s_%.30s.csv", length, file_name ? file_name : "", name);
    if (file_name && (file = fopen(path, "w")) != NULL) {
        s->scene.output = write_row;
        s->scene.output_ctx = file;
        s->scene.times = times;
        s->scene.n_times = POINTS - 1; /* the last row is for the end of the run */
        sprintf(path, "%.*s_%.30s_events.csv", length, file_name, name);
        event_file = fopen(path, "w");
    }
    status = stage_start(s);
    if (!status) status = stage_run(s, (double)s->end);
    printf("  %-10s %-44s %9.6f s %13.9g   (%9.6f s %13.9g)%s\n", name, what, (double)s->t, (double)s->y[i],
           wanted_t, wanted, status < 0 ? vm_strerror(status) : "");
    if (file) {
        write_row(s->t, s->y, &s->scene, file);
        fclose(file);
    }
    if (event_file) fclose(event_file);
    event_file = NULL;
}

int main(int argc, char **argv)
{
    turner_data turn = turner, tip = tippler;
    stator_data gap = {2.5, 1.5};
    stage s;
    int full;
    if (argc > 1 && strlen(argv[1]) > 4 && strlen(argv[1]) < 200) {
        file_name = argv[1];
        length = (int)strlen(file_name) - 4;
    }
    puts("The machines of chapter 1 as scenes: where they come to (reference)");
    vessel_on_regulated_hook(&s);
    play(&s, "pouring", "a hook tips a vessel until it is empty: rad", 0, 10, 1.57079632679489662);
    vessel_by_motor(&s);
    play(&s, "vessel", "tipped by a motor to 1.4 rad: rad/s", 1, 4.23898704805918765, 0.372068251670792583);
    turner_scene(&s, &turn, 1);
    play(&s, "turner", "a wagon is turned over: rad/s", 1, 1.84635466780631226, 3.49657701427779438);
    turner_scene(&s, &tip, 1);
    play(&s, "tippler", "with counterweights: rad/s", 1, 2.94061464196003694, 2.94501866090748102);
    wagon(&s);
    play(&s, "wagon", "fills 60 s, then empties: m/s", 1, 120, 44.9383328318419495);
    mechanism(&s);
    play(&s, "mechanism", "on a crank, a turn: rad/s", 1, 1.85978210307734631, 5.82581880164640765);
    mill(&s, &mill_driven, 0, 25);
    play(&s, "mill", "rolls 25 m: m/s", 1, 3.28047146698998200, 14.7999500519540368);
    regulator(&s);
    play(&s, "regulator", "holds its speed: switched off last at 9.43 s", 1, 10, 12.0231459473126);
    scoop(&s, &full);
    play(&s, "scoop", "cuts, carries and drops: rad/s", 1, 2, 2.03335511035973);
    excavator(&s);
    play(&s, "excavator", "five bodies, the scoop is filled: height, m", 25, 40, 0.397576169435684206);
    crane(&s);
    play(&s, "crane", "picks up, leaks, drops: m", 0, 12, 0.000712652643793425313);
    luffing_crane(&s);
    play(&s, "luffing", "a crane of four bodies: height of its load, m", 19, 8, 2.64793748421987867);
    dosing(&s, 40);
    s.end = 5;
    play(&s, "dosing", "a belt feeds itself: rad", 0, 5, 0.000907954100047924994);
    weighing(&s);
    play(&s, "weighing", "from lift-off to the largest angle: rad", 0, 2.0330313512972609, 0.234693965122421166);
    chain_heap(&s);
    play(&s, "heap", "Cayley's chain from a heap: m/s", 1, 0.921289371977640962, 3.61640221767435598);
    chain_winding(&s);
    play(&s, "winding", "a chain winds on a drum: rad/s", 1, 4.16723798047598732, 3.54964786985976963);
    stator(&s, &gap);
    play(&s, "stator", "a broken rotor meets the stator: rad", 2, 10.0667375197206978, 18.8738526581898339);
    reel(&s, 1, 40);
    play(&s, "reel", "a band winds up, layer by layer: rad/s", 1, 4.96711418419346504, 7.25340764780580859);
    two_stages(&s);
    play(&s, "rocket", "two stages, burnt out: mass centre, m", 14, 40, 3.125);
    puts("Numerical examples of the dissertation as scenes: where they are (reference)");
    figure18(&s, 0.625);
    s.end = 10;
    play(&s, "fig18", "the rest of a broken rotor: rad", 2, 10, 4.84962146546119455);
    example1(&s);
    s.end = 10;
    play(&s, "example1", "(398): m", 0, 10, 0.832947674575421393);
    figure30(&s);
    s.end = 10;
    play(&s, "fig30", "Laval's rotor, (514): m", 0, 10, -0.494339964193726892);
    figure32(&s);
    s.end = 5;
    play(&s, "fig32", "two bodies and a spring, (530): m", 0, 5, 1.35739338901332805);
    return 0;
}
