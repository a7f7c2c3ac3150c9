// The one file of a program that is linked to compare types, and never run.

int main() { return 0; }
