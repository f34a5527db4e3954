/* A spinning body throws off a part: how does the rest of it move? The answer goes to the serial monitor, 9600 baud. */
#define VM_USE_FLOAT
#include <varmass.h>

void setup()
{
    /* mass, inertia (xx yy zz xy xz yz), attitude (none: along the axes), position, velocity, angular velocity */
    vm_body whole = {5, {2, 2, 1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}, {10, 0, 0}, {0, 0, 3}};
    vm_body part = {1, {0.1f, 0.1f, 0.1f, 0, 0, 0}, {0, 0, 0, 0}, {0.4f, 0, 0}, {10, 2, 0}, {0, 0, 3}};
    vm_body rest = {};
    Serial.begin(9600);
    if (vm_separate(&whole, &part, NULL, &rest) != VM_OK) {
        Serial.println("no such separation");
        return;
    }
    Serial.print("velocity of the rest, m/s: ");
    Serial.print(rest.v.x);
    Serial.print(' ');
    Serial.println(rest.v.y);
    Serial.print("its angular velocity, rad/s: ");
    Serial.println(rest.omega.z);
}

void loop() {}
