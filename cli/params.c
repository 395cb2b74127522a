/* SPDX-License-Identifier: GPL-3.0-or-later
 * `weft params`: a script in, what -D can set out, as a table or as JSON. */
#include <config.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "cli/script.h"
#include "output/json.h"
#include "output/number.h"

enum { VALUE_TEXT = NUMBER_TEXT + 4 };

static void add_param(cJSON *list, const struct setting *s)
{
    cJSON *param = cJSON_CreateObject();
    json_text(param, "name", s->name);
    if (s->text)
        json_text(param, "default", s->text);
    else
        json_number(param, "default", s->number);
    if (s->low <= s->high) {
        cJSON *range = cJSON_AddObjectToObject(param, "range");
        json_number(range, "low", s->low);
        json_number(range, "high", s->high);
    } else {
        cJSON_AddNullToObject(param, "range");
    }
    json_text(param, "unit", s->unit);
    json_text(param, "text", s->about ? s->about : "");
    cJSON_AddItemToArray(list, param);
}

static enum status print_json(const struct scene *scene)
{
    cJSON *root = cJSON_CreateObject();
    json_text(root, "file", scene->file);
    cJSON *list = cJSON_AddArrayToObject(root, "params");
    for (const struct setting *s = scene->setting; s < scene->setting + scene->nsettings; s++)
        if (s->is_param)
            add_param(list, s);
    return json_print(root) ? STATUS_DONE : STATUS_FAILED;
}

/* A number as a script has it: lengths are kept in millimetres. */
static void print_value(char text[VALUE_TEXT], const struct setting *s, double value)
{
    number_print(text, value);
    if (strcmp(s->unit, "length") == 0)
        strcat(text, " mm");
}

static void print_table(const struct scene *scene)
{
    for (const struct setting *s = scene->setting; s < scene->setting + scene->nsettings; s++) {
        char value[VALUE_TEXT], low[VALUE_TEXT], high[VALUE_TEXT], range[2 * VALUE_TEXT + 8] = "";
        if (!s->is_param)
            continue;
        print_value(value, s, s->number);
        print_value(low, s, s->low);
        print_value(high, s, s->high);
        if (s->low <= s->high)
            snprintf(range, sizeof range, "in %s..%s", low, high);
        printf("%-12s = %-8s %-12s %s\n", s->name, s->text ? s->text : value, range, s->about ? s->about : "");
    }
}

enum status command_params(const struct options *options)
{
    struct script script;
    enum status status = script_load(&script, options->operand[0], options);
    if (status == STATUS_DONE && options->json)
        status = print_json(script.scene);
    else if (status == STATUS_DONE)
        print_table(script.scene);
    script_free(&script);
    return status;
}
